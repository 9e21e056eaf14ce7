/**
 * @file
 * For programs for b11 and b12, whose types of commands were declared here: they are in DataType.h, with NEURONDATAREADER_B12.
 */
#ifndef NEURONDATAREADER_SOCKETCOMMAND_H
#define NEURONDATAREADER_SOCKETCOMMAND_H

#include "DataType.h"

#endif
