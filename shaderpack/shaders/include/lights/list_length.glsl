// The word length_word of a cluster's bits: how many lamps it has, and where in the bits those are
// for which its list has no room. 0 before any list is made.
#if !defined INCLUDED_LIGHTS_LIST_LENGTH
#define INCLUDED_LIGHTS_LIST_LENGTH

/// `rest`: first word whose bits stay, plus 1; 0 when the list holds all.
uint pack_length(uint lamps, uint rest) { return lamps | rest << 16; }

uint packed_lamps(uint length) { return length & 0xffffu; }

uint packed_rest(uint length) { return length >> 16; }

#endif
