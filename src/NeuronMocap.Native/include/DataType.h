/**
 * @file
 * Types of the functions in NeuronDataReader.h. For C99 and newer, C++98 and newer; needs no windows.h, and goes before or after it.
 *
 * There are two generations. The names are those of b15 to b18, unless a macro is defined before the include:
 *   NEURONDATAREADER_B12  for programs that were written for b11 or b12,
 *   NEURONDATAREADER_B10  for programs that were written for b10: as B12, but frames come with a BvhDataHeader.
 */
#ifndef NEURONDATAREADER_DATATYPE_H
#define NEURONDATAREADER_DATATYPE_H

#include <stdint.h>

#ifndef __cplusplus
#include <stdbool.h>
#endif

#if defined(NEURONDATAREADER_B10) && !defined(NEURONDATAREADER_B12)
#define NEURONDATAREADER_B12
#endif

/* Version of the library that this one stands for: the newest there is, b18. No version of the stream's format. */
#define DR_MAJOR 1
#define DR_MINOR 1
#define DR_REVISION 3
#define DR_BUILDNUMB 470

/** Bytes of data in a CommandPack of b17 and b18. */
#define MAX_PACKETSIZE 100000

/* Functions are cdecl and callbacks stdcall on Windows. Elsewhere there is one convention, and programs for the vendor's headers define __OS_XUN__. */
#ifndef CALLBACK
#ifdef _WIN32
#define CALLBACK __stdcall
#else
#define CALLBACK
#endif
#endif
#if defined(__OS_XUN__) && !defined(_WIN32) && !defined(__stdcall)
#define __stdcall
#endif

/* What programs take from the vendor's headers, where nothing else brings it. windows.h and Objective-C have types of these names, and a program may have
   its own: the structs and functions here need none. NEURONDATAREADER_NO_BOOL leaves them all out. */
#ifndef NEURONDATAREADER_NO_BOOL
#ifndef TRUE
#define TRUE 1
#endif
#ifndef FALSE
#define FALSE 0
#endif
#ifndef NBOOL
#define NBOOL int
#endif
#if defined(NEURONDATAREADER_B12) && !defined(_WINDEF_) && !defined(_MINWINDEF_) && !defined(__OBJC__)
#ifndef BOOL
typedef int BOOL;
#endif
#ifndef UCHAR
typedef unsigned char UCHAR;
#endif
#endif
#endif

/* Anonymous structs are of C11; the vendor's types need one in C99 and C++. */
#if defined(__GNUC__)
#define NEURONDATAREADER_EXTENSION __extension__
#else
#define NEURONDATAREADER_EXTENSION
#endif

#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4201)
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A connection, UDP service or command connection. Opaque: no address, and only good for these functions. NULL is none. A value is never used again
 * after it was closed; functions do nothing with a closed or foreign one.
 */
typedef void *SOCKET_REF;

/** State of a connection or service. */
typedef enum _SocketStatus {
    CS_Running,  /**< Works. */
    CS_Starting, /**< Is being opened. */
    CS_OffWork   /**< Does not work: was never opened, failed, was closed, or the server has gone. */
} SocketStatus;

/** Order in which the three angles of a rotation are stored, first to last. R = first * second * third, on column vectors. */
typedef enum _RotateOrders {
    RO_XZY,
    RO_YXZ,    /**< The servers' default. */
    RO_XYZ,
    RO_YZX,
    RO_ZXY,
    RO_ZYX,
    RO_Unknown /**< Not told. */
} RotateOrders;

/** Which sensors are worn: the answer to Cmd_CombinationMode of b12. */
typedef enum _SensorCombinationModes {
    SC_ArmOnly,   /**< One arm. */
    SC_UpperBody, /**< The upper body. */
    SC_FullBody   /**< The whole body. */
} SensorCombinationModes;

#ifndef NEURONDATAREADER_B12

/** Commands of the command channel, b17 and b18: ZeroOut and the functions below it send them. */
typedef enum _CommandIdentity {
    Cmd_ZeroOutPosition = 1001,  /**< Zeroes out an avatar; see ZeroOut. */
    Cmd_ZeroOutAllAvatar = 1002, /**< The same for all avatars. */
    Cmd_BvhRotation = 1003,      /**< Rotation order of the BVH data. */
    Cmd_BoneSize = 1004,         /**< Dimensions of an avatar's body. */
    Cmd_BvhHeader = 1005         /**< Text of an avatar's BVH header. */
} CmdId;

#else

/** Commands on the data connection, b11 and b12. What their answers hold is told at CommandDataReceived. */
typedef enum _CommandIdentity {
    Cmd_BoneSize,          /**< Lengths of an avatar's bones. */
    Cmd_AvatarName,        /**< Name of an avatar. */
    Cmd_FaceDirection,     /**< Direction that an avatar faces. */
    Cmd_DataFrequency,     /**< Frames per second of an avatar. */
    Cmd_BvhInheritanceTxt, /**< Text of an avatar's BVH header. */
    Cmd_AvatarCount,       /**< Number of avatars; no avatar's own. */
    Cmd_CombinationMode,   /**< Sensors that an avatar wears. */
    Cmd_RegisterEvent,     /**< What BRRegisterAutoSyncParmeter sends. */
    Cmd_UnRegisterEvent    /**< What BRUnregisterAutoSyncParmeter sends. */
} CmdId;

#endif

#pragma pack(push, 1)

/** Version of the stream's data format, lowest part first: 1.1.0.0 is 0x01010000. No version of this library. */
typedef union DataVersion {
    uint32_t _VersionMask; /**< All four parts. */
    NEURONDATAREADER_EXTENSION struct {
        uint8_t BuildNumb; /**< Fourth part. */
        uint8_t Revision;  /**< Third part. */
        uint8_t Minor;     /**< Second part. */
        uint8_t Major;     /**< First part. */
    };
} DATA_VER;

#ifndef NEURONDATAREADER_B12

/**
 * Header of a frame of BVH data, b15 to b18; 64 bytes. Frames that came with the header of b12, or as text, have it too: their version is then
 * 1.1.0.0, and FrameIndex is counted by the library, from 0, for each avatar.
 */
typedef struct _BvhDataHeader {
    uint16_t Token1;        /**< 0xDDFF. */
    DATA_VER DataVersion;   /**< Version of the data format, 1.1.x.x. */
    uint16_t DataCount;     /**< Number of floats. 59 bones have 354, without displacement 180; with the Reference node 6 more. */
    uint8_t WithDisp;       /**< 1: every bone has a position. 0: only Hips, and the Reference node. */
    uint8_t WithReference;  /**< 1: the Reference node comes first, 6 floats. */
    uint32_t AvatarIndex;   /**< Number of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, filled up with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t FrameIndex;    /**< The server's counter, which may begin anywhere and wraps. */
    uint32_t Reserved;      /**< As sent. Axis Studio: the rotation order. */
    uint32_t Reserved1;     /**< As sent. Axis Studio: hours, minutes and seconds of the timecode. */
    uint32_t Reserved2;     /**< As sent. Axis Studio: the timecode's frame. */
    uint16_t Token2;        /**< 0xEEFF. */
} BvhDataHeader;

/** The manual's other name of the header. */
typedef BvhDataHeader BvhDataHeaderEx;

#else

/** Header of a frame of BVH data, b10 to b12; 64 bytes. Frames of newer servers are given it too, with the version 1.0.0.2. */
typedef struct _BvhDataHeader {
    uint16_t Token1;        /**< 0xDDFF. */
    DATA_VER DataVersion;   /**< Version of the data format, 1.0.x.x. */
    uint32_t DataCount;     /**< Number of floats. 59 bones have 354, without displacement 180; with the Reference node 6 more. */
    int32_t WithDisp;       /**< 1: every bone has a position. 0: only Hips, and the Reference node. */
    int32_t WithReference;  /**< 1: the Reference node comes first, 6 floats. */
    uint32_t AvatarIndex;   /**< Number of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, filled up with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t Reserved1;     /**< As sent; 0 in frames of newer servers. */
    uint32_t Reserved2;     /**< As sent; 0 in frames of newer servers. */
    uint16_t Token2;        /**< 0xEEFF. */
} BvhDataHeader;

/** The same 64 bytes with the names of b11 and b12. */
typedef struct _BvhDataHeaderEx {
    uint16_t Token1;        /**< 0xDDFF. */
    DATA_VER DataVersion;   /**< Version of the data format, 1.0.x.x. */
    uint32_t DataCount;     /**< Number of floats. 59 bones have 354, without displacement 180; with the Reference node 6 more. */
    int32_t WithDisp;       /**< 1: every bone has a position. 0: only Hips, and the Reference node. */
    int32_t WithReference;  /**< 1: the Reference node comes first, 6 floats. */
    uint32_t AvatarIndex;   /**< Number of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, filled up with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t IsCompressed;  /**< As sent; 0 in frames of newer servers. The floats are given as they came. */
    uint32_t Reserved1;     /**< As sent; 0 in frames of newer servers. */
    uint16_t Token2;        /**< 0xEEFF. */
} BvhDataHeaderEx;

#endif

/** Header of a frame of calculation data; 64 bytes. The same in all generations that have it. */
typedef struct _CalcDataHeader {
    uint16_t Token1;        /**< 0x88FF. */
    DATA_VER DataVersion;   /**< Version of the data format; 1.0.0.3 for what came as text. */
    uint32_t DataCount;     /**< Number of floats: 338 for 21 bones, 946 with both hands. */
    uint32_t AvatarIndex;   /**< Number of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, filled up with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t FrameIndex;    /**< The server's counter, which may begin anywhere and wraps. Counted here from 0 for what came as text. */
    uint32_t Reserved1;     /**< As sent. */
    uint32_t Reserved2;     /**< As sent. */
    uint32_t Reserved3;     /**< As sent. */
    uint16_t Token2;        /**< 0x99FF. */
} CalcDataHeader;

/** Dimensions of a body in metres; 48 bytes. */
typedef struct _BoneDimension {
    float Head;          /**< Length of the head. */
    float Neck;          /**< Length of the neck. */
    float Body;          /**< Length of the trunk. */
    float ShoulderWidth; /**< Width of the shoulders. */
    float UpperArm;      /**< Length of an upper arm. */
    float Forearm;       /**< Length of a forearm. */
    float Palm;          /**< Length of a hand. */
    float HipWidth;      /**< Width of the hip. */
    float UpperLeg;      /**< Length of an upper leg. */
    float LowerLeg;      /**< Length of a lower leg. */
    float HeelHeight;    /**< Height of a heel. */
    float FootLength;    /**< Length of a foot. */
} BoneDimension;

/** Length of one bone, in an answer to Cmd_BoneSize of b12; 64 bytes. */
typedef struct _CmdResponseBoneSize {
    uint8_t BoneName[60]; /**< Filled up with zeros. */
    float BoneLength;     /**< In the server's unit. */
} CmdResponseBoneSize;

#ifndef NEURONDATAREADER_B12

/** Header of a packet on the command channel; 16 bytes. The functions build and read these packets themselves. */
typedef struct _CommandPackHeader {
    uint16_t Token1;      /**< 0xAAFF. */
    uint16_t CommandType; /**< 0. */
    uint16_t CommandId;   /**< A CmdId. */
    uint32_t nDataBytes;  /**< Bytes that follow. */
    uint32_t nReserved;   /**< 0. */
    uint16_t Token2;      /**< 0xBBFF. */
} CommandPackHeader;

/**
 * A packet on the command channel with room for the largest data. Its size depends on the system: 100,016 bytes where long has 4 bytes, 200,016 where
 * it has 8. Only the header and nDataBytes bytes ever travel.
 */
typedef struct _CommandPack {
    CommandPackHeader cmdPackHeader; /**< Says how much of the data is used. */
    union {
        unsigned char cData[MAX_PACKETSIZE];
        char szData[MAX_PACKETSIZE];
        long lData[MAX_PACKETSIZE / 4];
        unsigned long ulData[MAX_PACKETSIZE / 4];
        float fData[MAX_PACKETSIZE / 4];
    } Data;                          /**< The packet's data, in any of these views. */
} CommandPack;

#else

/** Header of an answer on the data connection; 64 bytes. */
typedef struct _CommandPack {
    uint16_t Token1;          /**< 0xAAFF. */
    uint32_t DataVersion;     /**< Version of the command format; 1.0.0.2 is 0x01000002. */
    uint32_t DataLength;      /**< As sent. Servers differ in what they count: DataCount is what to go by. */
    uint32_t DataCount;       /**< What follows: entries of bones for Cmd_BoneSize, bytes of text for Cmd_BvhInheritanceTxt. */
    int32_t CommandId;        /**< A CmdId: what is answered. */
    uint8_t CmdParaments[40]; /**< Depends on the command: see CommandDataReceived. */
    uint32_t Reserved1;       /**< As sent. */
    uint16_t Token2;          /**< 0xBBFF. */
} CommandPack;

#endif

#pragma pack(pop)

/* Fails to compile where a compiler's options change the layout that the library has: short enums, other packing, another bool. */
#define NEURONDATAREADER_ASSERT(name, condition) typedef char NeuronDataReader_##name##_differs[(condition) ? 1 : -1]
NEURONDATAREADER_ASSERT(bool, sizeof(bool) == 1);
NEURONDATAREADER_ASSERT(SocketStatus, sizeof(SocketStatus) == 4);
NEURONDATAREADER_ASSERT(RotateOrders, sizeof(RotateOrders) == 4);
NEURONDATAREADER_ASSERT(SensorCombinationModes, sizeof(SensorCombinationModes) == 4);
NEURONDATAREADER_ASSERT(CmdId, sizeof(CmdId) == 4);
NEURONDATAREADER_ASSERT(DATA_VER, sizeof(DATA_VER) == 4);
NEURONDATAREADER_ASSERT(BvhDataHeader, sizeof(BvhDataHeader) == 64);
NEURONDATAREADER_ASSERT(BvhDataHeaderEx, sizeof(BvhDataHeaderEx) == 64);
NEURONDATAREADER_ASSERT(CalcDataHeader, sizeof(CalcDataHeader) == 64);
NEURONDATAREADER_ASSERT(BoneDimension, sizeof(BoneDimension) == 48);
NEURONDATAREADER_ASSERT(CmdResponseBoneSize, sizeof(CmdResponseBoneSize) == 64);
#ifdef NEURONDATAREADER_B12
NEURONDATAREADER_ASSERT(CommandPack, sizeof(CommandPack) == 64);
#else
NEURONDATAREADER_ASSERT(CommandPackHeader, sizeof(CommandPackHeader) == 16);
NEURONDATAREADER_ASSERT(CommandPack, sizeof(CommandPack) == 16 + MAX_PACKETSIZE / 4 * sizeof(long));
#endif

#ifndef NEURONDATAREADER_B12

/**
 * A callback that the headers of b17 and b18 declare, and that none of their functions takes: the answers of the command channel come back from the
 * functions. Programs of b11 and b12 have another of this name, in NeuronDataReader.h.
 *
 * @param customedObj An object of the program's.
 * @param sender      A command connection.
 * @param pack        A packet.
 * @return Not known.
 */
typedef bool (CALLBACK *CommandDataReceived)(void *customedObj, SOCKET_REF sender, CommandPack *pack);

#endif

#ifdef __cplusplus
}
#endif

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif
