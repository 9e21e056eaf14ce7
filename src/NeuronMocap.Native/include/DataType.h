/* Types of NeuronDataReader.h: manual sections 2.1 and 2.2. For C99 and C++98. */
#ifndef NEURONDATAREADER_DATATYPE_H
#define NEURONDATAREADER_DATATYPE_H

#include <stdint.h>

#ifdef __GNUC__
#define NEURONDATAREADER_EXTENSION __extension__
#else
#define NEURONDATAREADER_EXTENSION
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* A connection or service. Opaque; NULL is none. */
typedef void *SOCKET_REF;

typedef enum _SocketStatus {
    CS_Running,  /* working correctly */
    CS_Starting, /* trying to start */
    CS_OffWork   /* not working: never opened, failed, closed, or left by the server */
} SocketStatus;

typedef enum _RotateOrders {
    RO_XZY,
    RO_YXZ, /* Axis Neuron's default */
    RO_XYZ,
    RO_YZX,
    RO_ZXY,
    RO_ZYX,
    RO_Unknown
} RotateOrders;

#pragma pack(push, 1)

/* Version of the stream's data format, lowest part first. */
typedef union DataVersion {
    uint32_t _VersionMask;
    NEURONDATAREADER_EXTENSION struct {
        uint8_t BuildNumb;
        uint8_t Revision;
        uint8_t Minor;
        uint8_t Major;
    };
} DATA_VER;

/* Header of a frame of BVH data, 64 bytes. */
typedef struct BvhDataHeader {
    uint16_t Token1;       /* 0xDDFF */
    DATA_VER DataVersion;
    uint16_t DataCount;    /* floats that follow */
    uint8_t WithDisp;      /* 1: every bone has a position */
    uint8_t WithReference; /* 1: the Reference node comes first */
    uint32_t AvatarIndex;
    uint8_t AvatarName[32];
    uint32_t FrameIndex;
    uint32_t Reserved;
    uint32_t Reserved1;
    uint32_t Reserved2;
    uint16_t Token2;       /* 0xEEFF */
} BvhDataHeader;

/* Header of a frame of calculation data, 64 bytes. */
typedef struct CalcDataHeader {
    uint16_t Token1; /* 0x88FF */
    DATA_VER DataVersion;
    uint32_t DataCount;
    uint32_t AvatarIndex;
    uint8_t AvatarName[32];
    uint32_t FrameIndex;
    uint32_t Reserved1;
    uint32_t Reserved2;
    uint32_t Reserved3;
    uint16_t Token2; /* 0x99FF */
} CalcDataHeader;

/* Metres. */
typedef struct _BoneDimension {
    float Head;
    float Neck;
    float Body;
    float ShoulderWidth;
    float UpperArm;
    float Forearm;
    float Palm;
    float HipWidth;
    float UpperLeg;
    float LowerLeg;
    float HeelHeight;
    float FootLength;
} BoneDimension;

#pragma pack(pop)

#ifdef __cplusplus
}
#endif

#endif
