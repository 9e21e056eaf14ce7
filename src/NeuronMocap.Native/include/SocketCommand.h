/**
 * @file
 * For programs for b11 and b12, which include this file for the types of commands. The types are in DataType.h, with NEURONDATAREADER_B12.
 */
#ifndef NEURONDATAREADER_SOCKETCOMMAND_H
#define NEURONDATAREADER_SOCKETCOMMAND_H

#include "DataType.h"

#endif
