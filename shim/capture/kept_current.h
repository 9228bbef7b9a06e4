// Draws from arrays that a list keeps leave the current values as they were, as drivers' lists do.
#pragma once

#include "capture/entry.h"
#include "capture/slots.h"

namespace truequad {

// While a list keeps calls: the current values of `slots` are noted here when the list is called …
bool keep_noting_current(Entry& entry, SlotMask slots);
// … and set again here.
void keep_restoring_current(Entry& entry);

// When it is called (array_elements.cc).
void note_current(Entry& entry, SlotMask slots);
void restore_current(Entry& entry);

}  // namespace truequad
