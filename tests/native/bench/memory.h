/* Measures the memory that the receive thread takes while frames arrive. It should take none. */
#ifndef MEMORY_H
#define MEMORY_H

/* Call both on the receive thread, in a callback. memory_end prints the difference. */
void memory_begin(void);
void memory_end(void);

#endif
