/* Compile-time assertions for every size, offset and value of the library's structs and enums: protocol.md sections 2.1 to 2.6, manual section 2.1. */
#include <stddef.h>

#ifdef LAYOUT_WINDOWS_FIRST
#include "windows_like.h"
#endif
#include <NeuronDataReader.h>
#ifdef LAYOUT_WINDOWS_LAST
#include "windows_like.h"
#endif

#define JOIN(a, b) a##b
#define NAME_OF(line) JOIN(assertion_, line)
#define ASSERT(condition) typedef char NAME_OF(__LINE__)[(condition) ? 1 : -1]
#define FIELD(type, field, offset, size) ASSERT(offsetof(type, field) == (offset) && sizeof(((type *)0)->field) == (size))

ASSERT(CS_Running == 0 && CS_Starting == 1 && CS_OffWork == 2 && sizeof(SocketStatus) == 4);
ASSERT(RO_XZY == 0 && RO_YXZ == 1 && RO_XYZ == 2 && RO_YZX == 3 && RO_ZXY == 4 && RO_ZYX == 5 && RO_Unknown == 6 && sizeof(RotateOrders) == 4);
ASSERT(SC_ArmOnly == 0 && SC_UpperBody == 1 && SC_FullBody == 2 && sizeof(SensorCombinationModes) == 4);
ASSERT(BR_HEADER_NEW == 0 && BR_HEADER_OLD == 1 && sizeof(BRHeaderLayout) == 4);
ASSERT(MAX_PACKETSIZE == 100000);
ASSERT(DR_MAJOR == 1 && DR_MINOR == 1 && DR_REVISION == 3 && DR_BUILDNUMB == 470);
ASSERT(sizeof(bool) == 1 && sizeof(float) == 4 && sizeof(int) == 4);
ASSERT(sizeof(SOCKET_REF) == sizeof(void *));

ASSERT(sizeof(DATA_VER) == 4);
FIELD(DATA_VER, _VersionMask, 0, 4);
FIELD(DATA_VER, BuildNumb, 0, 1);
FIELD(DATA_VER, Revision, 1, 1);
FIELD(DATA_VER, Minor, 2, 1);
FIELD(DATA_VER, Major, 3, 1);

ASSERT(sizeof(CalcDataHeader) == 64);
FIELD(CalcDataHeader, Token1, 0, 2);
FIELD(CalcDataHeader, DataVersion, 2, 4);
FIELD(CalcDataHeader, DataCount, 6, 4);
FIELD(CalcDataHeader, AvatarIndex, 10, 4);
FIELD(CalcDataHeader, AvatarName, 14, 32);
FIELD(CalcDataHeader, FrameIndex, 46, 4);
FIELD(CalcDataHeader, Reserved1, 50, 4);
FIELD(CalcDataHeader, Reserved2, 54, 4);
FIELD(CalcDataHeader, Reserved3, 58, 4);
FIELD(CalcDataHeader, Token2, 62, 2);

ASSERT(sizeof(BoneDimension) == 48);
FIELD(BoneDimension, Head, 0, 4);
FIELD(BoneDimension, Neck, 4, 4);
FIELD(BoneDimension, Body, 8, 4);
FIELD(BoneDimension, ShoulderWidth, 12, 4);
FIELD(BoneDimension, UpperArm, 16, 4);
FIELD(BoneDimension, Forearm, 20, 4);
FIELD(BoneDimension, Palm, 24, 4);
FIELD(BoneDimension, HipWidth, 28, 4);
FIELD(BoneDimension, UpperLeg, 32, 4);
FIELD(BoneDimension, LowerLeg, 36, 4);
FIELD(BoneDimension, HeelHeight, 40, 4);
FIELD(BoneDimension, FootLength, 44, 4);

ASSERT(sizeof(CmdResponseBoneSize) == 64);
FIELD(CmdResponseBoneSize, BoneName, 0, 60);
FIELD(CmdResponseBoneSize, BoneLength, 60, 4);

ASSERT(sizeof(CmdId) == 4);
ASSERT(sizeof(BvhDataHeader) == 64);
ASSERT(sizeof(BvhDataHeaderEx) == 64);

#ifndef NEURONDATAREADER_B12

ASSERT(Cmd_ZeroOutPosition == 1001 && Cmd_ZeroOutAllAvatar == 1002 && Cmd_BvhRotation == 1003 && Cmd_BoneSize == 1004 && Cmd_BvhHeader == 1005);

FIELD(BvhDataHeader, Token1, 0, 2);
FIELD(BvhDataHeader, DataVersion, 2, 4);
FIELD(BvhDataHeader, DataCount, 6, 2);
FIELD(BvhDataHeader, WithDisp, 8, 1);
FIELD(BvhDataHeader, WithReference, 9, 1);
FIELD(BvhDataHeader, AvatarIndex, 10, 4);
FIELD(BvhDataHeader, AvatarName, 14, 32);
FIELD(BvhDataHeader, FrameIndex, 46, 4);
FIELD(BvhDataHeader, Reserved, 50, 4);
FIELD(BvhDataHeader, Reserved1, 54, 4);
FIELD(BvhDataHeader, Reserved2, 58, 4);
FIELD(BvhDataHeader, Token2, 62, 2);

ASSERT(sizeof(CommandPackHeader) == 16);
FIELD(CommandPackHeader, Token1, 0, 2);
FIELD(CommandPackHeader, CommandType, 2, 2);
FIELD(CommandPackHeader, CommandId, 4, 2);
FIELD(CommandPackHeader, nDataBytes, 6, 4);
FIELD(CommandPackHeader, nReserved, 10, 4);
FIELD(CommandPackHeader, Token2, 14, 2);

ASSERT(sizeof(CommandPack) == (sizeof(long) == 4 ? 100016 : 200016));
FIELD(CommandPack, cmdPackHeader, 0, 16);
FIELD(CommandPack, Data.cData, 16, 100000);
FIELD(CommandPack, Data.szData, 16, 100000);
FIELD(CommandPack, Data.lData, 16, 25000 * sizeof(long));
FIELD(CommandPack, Data.ulData, 16, 25000 * sizeof(long));
FIELD(CommandPack, Data.fData, 16, 100000);

#else

ASSERT(Cmd_BoneSize == 0 && Cmd_AvatarName == 1 && Cmd_FaceDirection == 2 && Cmd_DataFrequency == 3 && Cmd_BvhInheritanceTxt == 4);
ASSERT(Cmd_AvatarCount == 5 && Cmd_CombinationMode == 6 && Cmd_RegisterEvent == 7 && Cmd_UnRegisterEvent == 8);
ASSERT(sizeof(BOOL) == 4 && sizeof(UCHAR) == 1);

FIELD(BvhDataHeader, Token1, 0, 2);
FIELD(BvhDataHeader, DataVersion, 2, 4);
FIELD(BvhDataHeader, DataCount, 6, 4);
FIELD(BvhDataHeader, WithDisp, 10, 4);
FIELD(BvhDataHeader, WithReference, 14, 4);
FIELD(BvhDataHeader, AvatarIndex, 18, 4);
FIELD(BvhDataHeader, AvatarName, 22, 32);
FIELD(BvhDataHeader, Reserved1, 54, 4);
FIELD(BvhDataHeader, Reserved2, 58, 4);
FIELD(BvhDataHeader, Token2, 62, 2);

FIELD(BvhDataHeaderEx, Token1, 0, 2);
FIELD(BvhDataHeaderEx, DataVersion, 2, 4);
FIELD(BvhDataHeaderEx, DataCount, 6, 4);
FIELD(BvhDataHeaderEx, WithDisp, 10, 4);
FIELD(BvhDataHeaderEx, WithReference, 14, 4);
FIELD(BvhDataHeaderEx, AvatarIndex, 18, 4);
FIELD(BvhDataHeaderEx, AvatarName, 22, 32);
FIELD(BvhDataHeaderEx, IsCompressed, 54, 4);
FIELD(BvhDataHeaderEx, Reserved1, 58, 4);
FIELD(BvhDataHeaderEx, Token2, 62, 2);

ASSERT(sizeof(CommandPack) == 64);
FIELD(CommandPack, Token1, 0, 2);
FIELD(CommandPack, DataVersion, 2, 4);
FIELD(CommandPack, DataLength, 6, 4);
FIELD(CommandPack, DataCount, 10, 4);
FIELD(CommandPack, CommandId, 14, 4);
FIELD(CommandPack, CmdParaments, 18, 40);
FIELD(CommandPack, Reserved1, 58, 4);
FIELD(CommandPack, Token2, 62, 2);

#endif
