/**
 * @file
 * Types of the functions in NeuronDataReader.h, for C99 and C++98 and newer. Does not need windows.h; include it before or after windows.h.
 *
 * The types exist in two generations. The names are those of b15 to b18, unless a macro is defined before the include:
 *   NEURONDATAREADER_B12  for programs that were written for b11 or b12
 *   NEURONDATAREADER_B10  for programs that were written for b10: like B12, but frames come with a BvhDataHeader
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

/* Version of the vendor's library that this one replaces: the newest, b18. It is not the version of the stream's format. */
#define DR_MAJOR 1
#define DR_MINOR 1
#define DR_REVISION 3
#define DR_BUILDNUMB 470

/** Bytes of data in a CommandPack of b17 and b18. */
#define MAX_PACKETSIZE 100000

/* On Windows functions are cdecl and callbacks stdcall. Elsewhere there is one convention, and programs for the vendor's headers define __OS_XUN__. */
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

/* Types that programs expect from the vendor's headers if no other header defines them. windows.h, Objective-C and the program itself may define these
   names, so the structs and functions here do not use them. NEURONDATAREADER_NO_BOOL leaves all of them out. */
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

/* Anonymous structs belong to C11, but a type of the vendor needs one in C99 and C++, too. */
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
 * A connection, UDP service or command connection. The handle is opaque: it is not an address and only works with these functions. NULL means none. A
 * value is never used again after it was closed. Functions ignore closed and foreign handles.
 */
typedef void *SOCKET_REF;

/** State of a connection or service. */
typedef enum _SocketStatus {
    CS_Running,  /**< The connection works. */
    CS_Starting, /**< The connection is being opened. */
    CS_OffWork   /**< The connection does not work: never opened, failed, closed, or ended by the server. */
} SocketStatus;

/** Order in which the three angles of a rotation are stored, first to last. R = first * second * third, for column vectors. */
typedef enum _RotateOrders {
    RO_XZY,
    RO_YXZ,    /**< Default of the servers. */
    RO_XYZ,
    RO_YZX,
    RO_ZXY,
    RO_ZYX,
    RO_Unknown /**< Unknown. */
} RotateOrders;

/** Sensors that an avatar wears: the answer to Cmd_CombinationMode of b12. */
typedef enum _SensorCombinationModes {
    SC_ArmOnly,   /**< One arm. */
    SC_UpperBody, /**< The upper body. */
    SC_FullBody   /**< The whole body. */
} SensorCombinationModes;

#ifndef NEURONDATAREADER_B12

/** Commands of the command channel, b17 and b18. ZeroOut and the functions after it send them. */
typedef enum _CommandIdentity {
    Cmd_ZeroOutPosition = 1001,  /**< Zeroes out an avatar; see ZeroOut. */
    Cmd_ZeroOutAllAvatar = 1002, /**< Zeroes out all avatars. */
    Cmd_BvhRotation = 1003,      /**< Rotation order of the BVH data. */
    Cmd_BoneSize = 1004,         /**< Dimensions of an avatar's body. */
    Cmd_BvhHeader = 1005         /**< Text of an avatar's BVH header. */
} CmdId;

#else

/** Commands on the data connection, b11 and b12. CommandDataReceived describes their answers. */
typedef enum _CommandIdentity {
    Cmd_BoneSize,          /**< Lengths of an avatar's bones. */
    Cmd_AvatarName,        /**< Name of an avatar. */
    Cmd_FaceDirection,     /**< Direction in which an avatar faces. */
    Cmd_DataFrequency,     /**< Frames per second of an avatar. */
    Cmd_BvhInheritanceTxt, /**< Text of an avatar's BVH header. */
    Cmd_AvatarCount,       /**< Number of avatars. Does not belong to an avatar. */
    Cmd_CombinationMode,   /**< Sensors that an avatar wears. */
    Cmd_RegisterEvent,     /**< Sent by BRRegisterAutoSyncParmeter. */
    Cmd_UnRegisterEvent    /**< Sent by BRUnregisterAutoSyncParmeter. */
} CmdId;

#endif

#pragma pack(push, 1)

/** Version of the stream's data format, lowest part first: 1.1.0.0 is 0x01010000. It is not the version of this library. */
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
 * Header of a frame of BVH data, b15 to b18; 64 bytes. Frames that arrived with the header of b12 or as text have it, too. Their version is then
 * 1.1.0.0, and the library counts their FrameIndex from 0 for each avatar.
 */
typedef struct _BvhDataHeader {
    uint16_t Token1;        /**< 0xDDFF. */
    DATA_VER DataVersion;   /**< Version of the data format, 1.1.x.x. */
    uint16_t DataCount;     /**< Number of floats: 354 for 59 bones, or 180 without displacement. The reference adds 6. */
    uint8_t WithDisp;       /**< 1: every bone has a position. 0: only the hips and the reference have one. */
    uint8_t WithReference;  /**< 1: the reference comes first, 6 floats. */
    uint32_t AvatarIndex;   /**< Index of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, padded with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t FrameIndex;    /**< The counter of the server. It may start at any number, and it wraps. */
    uint32_t Reserved;      /**< Reserved, as sent. Axis Studio: the rotation order. */
    uint32_t Reserved1;     /**< Reserved, as sent. Axis Studio: hours, minutes and seconds of the timecode. */
    uint32_t Reserved2;     /**< Reserved, as sent. Axis Studio: the frame of the timecode. */
    uint16_t Token2;        /**< 0xEEFF. */
} BvhDataHeader;

/** Another name of the header in the manual. */
typedef BvhDataHeader BvhDataHeaderEx;

#else

/** Header of a frame of BVH data, b10 to b12; 64 bytes. Frames of newer servers get it, too, with the version 1.0.0.2. */
typedef struct _BvhDataHeader {
    uint16_t Token1;        /**< 0xDDFF. */
    DATA_VER DataVersion;   /**< Version of the data format, 1.0.x.x. */
    uint32_t DataCount;     /**< Number of floats: 354 for 59 bones, or 180 without displacement. The reference adds 6. */
    int32_t WithDisp;       /**< 1: every bone has a position. 0: only the hips and the reference have one. */
    int32_t WithReference;  /**< 1: the reference comes first, 6 floats. */
    uint32_t AvatarIndex;   /**< Index of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, padded with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t Reserved1;     /**< Reserved, as sent. 0 in frames of newer servers. */
    uint32_t Reserved2;     /**< Reserved, as sent. 0 in frames of newer servers. */
    uint16_t Token2;        /**< 0xEEFF. */
} BvhDataHeader;

/** The same 64 bytes with the field names of b11 and b12. */
typedef struct _BvhDataHeaderEx {
    uint16_t Token1;        /**< 0xDDFF. */
    DATA_VER DataVersion;   /**< Version of the data format, 1.0.x.x. */
    uint32_t DataCount;     /**< Number of floats: 354 for 59 bones, or 180 without displacement. The reference adds 6. */
    int32_t WithDisp;       /**< 1: every bone has a position. 0: only the hips and the reference have one. */
    int32_t WithReference;  /**< 1: the reference comes first, 6 floats. */
    uint32_t AvatarIndex;   /**< Index of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, padded with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t IsCompressed;  /**< As sent. 0 in frames of newer servers. The floats are passed on as they arrived. */
    uint32_t Reserved1;     /**< Reserved, as sent. 0 in frames of newer servers. */
    uint16_t Token2;        /**< 0xEEFF. */
} BvhDataHeaderEx;

#endif

/** Header of a frame of calculation data; 64 bytes. The same in all generations that have it. */
typedef struct _CalcDataHeader {
    uint16_t Token1;        /**< 0x88FF. */
    DATA_VER DataVersion;   /**< Version of the data format. 1.0.0.3 for frames that arrived as text. */
    uint32_t DataCount;     /**< Number of floats: 338 for 21 bones, 946 with both hands. */
    uint32_t AvatarIndex;   /**< Index of the avatar, from 0. */
    uint8_t AvatarName[32]; /**< UTF-8, padded with zeros. A name of 32 bytes has no zero at its end. */
    uint32_t FrameIndex;    /**< The counter of the server. It may start at any number, and it wraps. For text, counted by the library from 0. */
    uint32_t Reserved1;     /**< Reserved, as sent. */
    uint32_t Reserved2;     /**< Reserved, as sent. */
    uint32_t Reserved3;     /**< Reserved, as sent. */
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
    float HipWidth;      /**< Width of the hips. */
    float UpperLeg;      /**< Length of an upper leg. */
    float LowerLeg;      /**< Length of a lower leg. */
    float HeelHeight;    /**< Height of a heel. */
    float FootLength;    /**< Length of a foot. */
} BoneDimension;

/** Length of one bone, in an answer to Cmd_BoneSize of b12; 64 bytes. */
typedef struct _CmdResponseBoneSize {
    uint8_t BoneName[60]; /**< Name of the bone, padded with zeros. */
    float BoneLength;     /**< Length, in the unit of the server. */
} CmdResponseBoneSize;

#ifndef NEURONDATAREADER_B12

/** Header of a packet on the command channel; 16 bytes. The functions build and read these packets themselves. */
typedef struct _CommandPackHeader {
    uint16_t Token1;      /**< 0xAAFF. */
    uint16_t CommandType; /**< 0. */
    uint16_t CommandId;   /**< A CmdId. */
    uint32_t nDataBytes;  /**< Number of bytes that follow. */
    uint32_t nReserved;   /**< 0. */
    uint16_t Token2;      /**< 0xBBFF. */
} CommandPackHeader;

/**
 * A packet on the command channel with room for the largest data. Its size depends on the system: 100,016 bytes if long has 4 bytes, 200,016 if it has
 * 8. Only the header and nDataBytes bytes are sent.
 */
typedef struct _CommandPack {
    CommandPackHeader cmdPackHeader; /**< Gives the size of the used data. */
    union {
        unsigned char cData[MAX_PACKETSIZE];
        char szData[MAX_PACKETSIZE];
        long lData[MAX_PACKETSIZE / 4];
        unsigned long ulData[MAX_PACKETSIZE / 4];
        float fData[MAX_PACKETSIZE / 4];
    } Data;                          /**< The data of the packet, in any of these views. */
} CommandPack;

#else

/** Header of an answer on the data connection; 64 bytes. */
typedef struct _CommandPack {
    uint16_t Token1;          /**< 0xAAFF. */
    uint32_t DataVersion;     /**< Version of the command format; 1.0.0.2 is 0x01000002. */
    uint32_t DataLength;      /**< As sent. Servers count differently, so use DataCount instead. */
    uint32_t DataCount;       /**< Number of bones for Cmd_BoneSize, number of bytes for Cmd_BvhInheritanceTxt. */
    int32_t CommandId;        /**< A CmdId: the command that is answered. */
    uint8_t CmdParaments[40]; /**< Depends on the command: see CommandDataReceived. */
    uint32_t Reserved1;       /**< Reserved, as sent. */
    uint16_t Token2;          /**< 0xBBFF. */
} CommandPack;

#endif

#pragma pack(pop)

/* Compilation fails if compiler options change the layouts that the library uses: short enums, other packing, another bool. */
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
 * A callback that the headers of b17 and b18 declare, but that none of their functions takes. The functions themselves return the answers of the command
 * channel. For programs of b11 and b12, NeuronDataReader.h declares another callback with this name.
 *
 * @param customedObj An object of the program.
 * @param sender      A command connection.
 * @param pack        A packet.
 * @return Unknown.
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
