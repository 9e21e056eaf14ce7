/* The C functions of NeuronDataReader: manual section 2.3. For C99 and C++98. */
#ifndef NEURONDATAREADER_H
#define NEURONDATAREADER_H

#include "DataType.h"

#ifndef __cplusplus
#include <stdbool.h>
#endif

#ifdef _WIN32
#define NEURONDATAREADER_API __declspec(dllimport)
#ifndef CALLBACK
#define CALLBACK __stdcall
#endif
#else
#define NEURONDATAREADER_API
#ifndef CALLBACK
#define CALLBACK
#endif
#endif
#define BDR_API NEURONDATAREADER_API

#ifdef __cplusplus
extern "C" {
#endif

typedef void (CALLBACK *FrameDataReceived)(void *customedObj, SOCKET_REF sender, BvhDataHeader *header, float *data);
typedef void (CALLBACK *CalculationDataReceived)(void *customedObj, SOCKET_REF sender, CalcDataHeader *header, float *data);
typedef void (CALLBACK *SocketStatusChanged)(void *customedObj, SOCKET_REF sender, SocketStatus status, char *message);

NEURONDATAREADER_API void BRRegisterFrameDataCallback(void *customedObj, FrameDataReceived handle);
NEURONDATAREADER_API void BRRegisterCalculationDataCallback(void *customedObj, CalculationDataReceived handle);
NEURONDATAREADER_API void BRRegisterSocketStatusCallback(void *customedObj, SocketStatusChanged handle);
NEURONDATAREADER_API SOCKET_REF BRConnectTo(char *serverIP, int nPort);
NEURONDATAREADER_API SOCKET_REF BRStartUDPServiceAt(int nPort);
NEURONDATAREADER_API void BRCloseSocket(SOCKET_REF sockRef);
NEURONDATAREADER_API SocketStatus BRGetSocketStatus(SOCKET_REF sockRef);
NEURONDATAREADER_API char *BRGetLastErrorMessage(void);
NEURONDATAREADER_API SOCKET_REF BRConnectCmd(char *serverIP, int nPort);
NEURONDATAREADER_API bool ZeroOut(SOCKET_REF sockRef, int avatarIndex);
NEURONDATAREADER_API bool ZeroOutAll(SOCKET_REF sockRef);
NEURONDATAREADER_API bool GetBvhRotation(SOCKET_REF sockRef, RotateOrders *order);
NEURONDATAREADER_API bool GetBoneSize(SOCKET_REF sockRef, int avatarIndex, BoneDimension *dimensions);
NEURONDATAREADER_API bool GetBvhHeader(SOCKET_REF sockRef, int avatarIndex, char *data, int len);

#ifdef __cplusplus
}
#endif

#endif
