/* Tests only compile this file. It uses the names that programs take from the vendor's headers. With HOST_DEFINES, the program defines the common names
   itself, as published programs do. */
#include <stddef.h>

#define __OS_XUN__ 1

#ifdef HOST_DEFINES
#define BOOL int
#define UCHAR unsigned char
#define NBOOL long
#define TRUE (1 == 1)
#define FALSE (1 == 0)
#endif

#ifdef __cplusplus
struct _BvhDataHeader;
struct _BvhDataHeaderEx;
struct _CalcDataHeader;
#endif

#ifdef COMMANDS_FIRST
#include "SocketCommand.h"
#include <NeuronDataReader.h>
#else
#include <NeuronDataReader.h>
#include "SocketCommand.h"
#endif

void take_tags(struct _BvhDataHeader *motion, struct _CalcDataHeader *calculation, enum _CommandIdentity command);
void take_tags(struct _BvhDataHeader *motion, struct _CalcDataHeader *calculation, enum _CommandIdentity command)
{
    BvhDataHeader *same_motion = motion;
    CalcDataHeader *same_calculation = calculation;
    CmdId same_command = command;

    same_motion->AvatarIndex = same_command == Cmd_BoneSize ? 1 : same_calculation->AvatarIndex;
}

void __stdcall take_frame(void *object, SOCKET_REF sender, BvhDataHeaderEx *header, float *data);

#ifdef NEURONDATAREADER_B12

static void __stdcall on_command(void *object, SOCKET_REF sender, CommandPack *pack, void *data)
{
    *(unsigned char *)object = sender != NULL && data != NULL ? (unsigned char)pack->CommandId : (unsigned char)0;
}

void use_ex(struct _BvhDataHeaderEx *header);
void use_ex(struct _BvhDataHeaderEx *header)
{
    BvhDataHeaderEx *same = header;
    same->IsCompressed = 0;
}

#ifndef NEURONDATAREADER_NO_BOOL
BOOL fetch(SOCKET_REF reader);
BOOL fetch(SOCKET_REF reader)
{
    return BRCommandFetchDataFromServer(reader, Cmd_AvatarCount) ? TRUE : FALSE;
}
#endif

#else

static bool __stdcall on_command(void *object, SOCKET_REF sender, CommandPack *pack)
{
    *(unsigned char *)object = pack->Data.cData[0];
    return sender != NULL;
}

#endif

CommandDataReceived command_callback(void);
CommandDataReceived command_callback(void)
{
    return on_command;
}

bool call_by_name_in_heading(SOCKET_REF commands, BoneDimension *size);
bool call_by_name_in_heading(SOCKET_REF commands, BoneDimension *size)
{
    return BRGetBoneSize(commands, 0, size);
}

#ifndef NEURONDATAREADER_NO_BOOL
NBOOL truth(void);
NBOOL truth(void)
{
    return TRUE != FALSE;
}
#endif
