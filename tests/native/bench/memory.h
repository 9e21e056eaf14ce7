/* What memory the receive thread takes while frames come: nothing, it should be. */
#ifndef MEMORY_H
#define MEMORY_H

/* Both on the receive thread, in a callback: the difference is printed. */
void memory_begin(void);
void memory_end(void);

#endif
