/**
 * @file
 * The functions of NeuronDataReader. For C99 and newer, C++98 and newer; goes before or after windows.h. DataType.h tells how programs for b10 to b12
 * include it.
 *
 * Order of calls: register callbacks, connect, and close at the end. A program that exits without closing is not held up by the library.
 *
 * Threads: all functions may be called from any thread, and from callbacks. None throws, and none does anything with NULL, closed or foreign handles.
 * Callbacks of a connection or UDP service run one at a time, on its receive thread: its own for the first sixteen TCP connections, otherwise whichever
 * of the library's is free. Those of two connections run at once. While a callback runs its connection reads nothing, so a slow one makes the server
 * wait or lose frames. No C++ exception and no longjmp may leave a callback.
 *
 * Text is UTF-8.
 */
#ifndef NEURONDATAREADER_H
#define NEURONDATAREADER_H

#include "DataType.h"

/* DataType.h has the convention of callbacks. */
#ifdef _WIN32
#define NEURONDATAREADER_API __declspec(dllimport)
#define NEURONDATAREADER_CALL __cdecl
#else
#define NEURONDATAREADER_API
#define NEURONDATAREADER_CALL
#endif

/** The older name of NEURONDATAREADER_API. */
#ifndef BDR_API
#define BDR_API NEURONDATAREADER_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Called with every frame of BVH data, on the receive thread of its connection or service. The first may come before BRConnectTo has returned.
 *
 * Positions are in centimetres, angles in degrees; each rotation relative to the parent bone, its angles in the server's rotation order (YXZ unless
 * it was changed there). Order of the bones: manual, appendix A.
 *
 * @param customedObj What was registered with the callback.
 * @param sender      The connection or service.
 * @param header      Says what the floats are. Valid, and free to be changed, during the call; aligned to 16 bytes.
 * @param data        header->DataCount floats, as sent. Valid, and free to be changed, during the call; aligned to 16 bytes.
 */
#ifdef NEURONDATAREADER_B10
typedef void (CALLBACK *FrameDataReceived)(void *customedObj, SOCKET_REF sender, BvhDataHeader *header, float *data);
#else
typedef void (CALLBACK *FrameDataReceived)(void *customedObj, SOCKET_REF sender, BvhDataHeaderEx *header, float *data);
#endif

/**
 * Called with every frame of calculation data, on the receive thread of its connection or service.
 *
 * 16 floats per bone: position x y z in metres, velocity x y z, orientation w x y z, acceleration x y z and angular velocity x y z, the last two in the
 * sensor's own axes. 21 bones, then two floats that are 1 while the left and the right foot touch the ground, then 38 bones of the hands. Order of the
 * bones: manual, appendix C.
 *
 * @param customedObj What was registered with the callback; the vendor's library passed the BVH callback's object.
 * @param sender      The connection or service.
 * @param header      Says what the floats are. Valid, and free to be changed, during the call; aligned to 16 bytes.
 * @param data        header->DataCount floats, as sent. Valid, and free to be changed, during the call; aligned to 16 bytes.
 */
typedef void (CALLBACK *CalculationDataReceived)(void *customedObj, SOCKET_REF sender, CalcDataHeader *header, float *data);

/**
 * Called with what becomes of a TCP connection: on the thread that connects, "Connecting to {ip}:{port} ...\n" (starting), then "Successfully connected
 * to '{ip}:{port}'." (running), or "Failed to connect to '{ip}:{port}'." (starting) and "Service is stoped\n" (off work). When the server ends the
 * connection, on a thread of the library after the last frame, "Failed to read data." and "Data thread exited.\n" (both running, although
 * BRGetSocketStatus then says off work). On the thread that closes, "Service is stoped\n" (off work). The texts are the vendor's, letter by letter. Not
 * called for UDP services and command connections.
 *
 * @param customedObj What was registered with the callback.
 * @param sender      The connection: the value that BRConnectTo returns later, if it succeeds.
 * @param status      The new state.
 * @param message     What happened. Valid during the call.
 */
typedef void (CALLBACK *SocketStatusChanged)(void *customedObj, SOCKET_REF sender, SocketStatus status, char *message);

/**
 * Sets the callback of BVH frames. There is one for the process; a call replaces it together with its object, from the next frame on. A frame whose
 * callback has begun may still be using the old object.
 *
 * @param customedObj Passed to the callback as it is.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterFrameDataCallback(void *customedObj, FrameDataReceived handle);

/**
 * Sets the callback of calculation frames: as BRRegisterFrameDataCallback.
 *
 * @param customedObj Passed to the callback as it is.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterCalculationDataCallback(void *customedObj, CalculationDataReceived handle);

/**
 * Sets the callback of status changes: as BRRegisterFrameDataCallback.
 *
 * @param customedObj Passed to the callback as it is.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterSocketStatusCallback(void *customedObj, SocketStatusChanged handle);

/**
 * Connects to a server over TCP. Returns when the connection stands or has failed, at most after about 5 s.
 *
 * @param serverIP Address or name of the server. The vendor's library ended the process for a name that it could not find.
 * @param nPort    Its port, 1 to 65535; 7001 for BVH and 7003 for calculation data unless changed there.
 * @return The connection. Where one to the same place and port lives, that one; to a status callback that is told of a connection's beginning it is
 *         given while it is still starting, too. NULL when it failed: BRGetLastErrorMessage tells why.
 */
NEURONDATAREADER_API SOCKET_REF NEURONDATAREADER_CALL BRConnectTo(const char *serverIP, int nPort);

/**
 * Receives over UDP, from any sender. Other programs that share the port may receive on it too; which of them gets a datagram, the system decides.
 *
 * @param nPort Port to receive on, 1 to 65535. 0 lets the system choose one, of which nobody is told.
 * @return The service, a new one with every call. NULL when it failed: BRGetLastErrorMessage tells why.
 */
NEURONDATAREADER_API SOCKET_REF NEURONDATAREADER_CALL BRStartUDPServiceAt(int nPort);

/**
 * Closes a connection, UDP service or command connection. Once it has returned, no callback of that connection begins. One that runs is waited for, for
 * 75 ms: it may wait for the thread that closes. What it was given stays valid until it ends. NULL, and closing again, do nothing.
 *
 * @param sockRef What to close.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRCloseSocket(SOCKET_REF sockRef);

/**
 * Looks at a connection, UDP service or command connection.
 *
 * @param sockRef A handle.
 * @return Its state. CS_OffWork for NULL, for what was closed, and, other than in the vendor's library, once the server has gone.
 */
NEURONDATAREADER_API SocketStatus NEURONDATAREADER_CALL BRGetSocketStatus(SOCKET_REF sockRef);

/**
 * The last error of the process, for people to read: "No error." at first. No success clears it, and all threads share it.
 *
 * @return Always the same memory, never NULL, with a zero byte at its end at any moment. The next error of any thread overwrites it: copy what is to
 *         stay. Neither change nor free it.
 */
NEURONDATAREADER_API char *NEURONDATAREADER_CALL BRGetLastErrorMessage(void);

/**
 * Opens a command connection to a server: manual section 2.3.9. It calls no status callback.
 *
 * @param serverIP Address or name of the server.
 * @param nPort    Its command port, 1 to 65535; no data port.
 * @return The connection, for the functions below. Where one to the same place and port lives, that one. NULL when it failed, at most after about 5 s:
 *         BRGetLastErrorMessage tells why.
 */
NEURONDATAREADER_API SOCKET_REF NEURONDATAREADER_CALL BRConnectCmd(const char *serverIP, int nPort);

/**
 * Asks the server to zero out an avatar. What that changes, the direction, the position or both, is not documented.
 *
 * As all commands it returns with the server's answer, or after 3 s with false. After a failure the connection can be used again; it connects again by itself.
 *
 * @param sockRef     A command connection. For anything else the answer is false, and nothing is sent.
 * @param avatarIndex Number of the avatar, from 0.
 * @return Whether the server has done it.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL ZeroOut(SOCKET_REF sockRef, int avatarIndex);

/**
 * Asks the server to zero out all avatars; see ZeroOut.
 *
 * @param sockRef A command connection.
 * @return Whether the server has done it.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL ZeroOutAll(SOCKET_REF sockRef);

/**
 * Asks for the rotation order of the server's BVH data.
 *
 * @param sockRef A command connection.
 * @param order   Set to the order; to RO_Unknown when it was not told. NULL makes the call fail.
 * @return Whether the server told it. An order that does not exist is no answer.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL GetBvhRotation(SOCKET_REF sockRef, RotateOrders *order);

/**
 * Asks for the dimensions of an avatar's body.
 *
 * @param sockRef     A command connection.
 * @param avatarIndex Number of the avatar, from 0.
 * @param dimensions  Set to the dimensions, in metres; to zeros when they were not told. NULL makes the call fail.
 * @return Whether the server told them, all of them.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL GetBoneSize(SOCKET_REF sockRef, int avatarIndex, BoneDimension *dimensions);

/**
 * GetBoneSize, by the name in the heading of the manual's section 2.3.13.
 *
 * @param sockRef     A command connection.
 * @param avatarIndex Number of the avatar, from 0.
 * @param dimensions  Set to the dimensions, in metres; to zeros when they were not told. NULL makes the call fail.
 * @return Whether the server told them, all of them.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL BRGetBoneSize(SOCKET_REF sockRef, int avatarIndex, BoneDimension *dimensions);

/**
 * Asks for the BVH header of an avatar: the text up to the motion data, about 10,000 bytes.
 *
 * @param sockRef     A command connection.
 * @param avatarIndex Number of the avatar, from 0.
 * @param data        Room for len bytes. Takes the text and, where there is room, a zero byte, which the vendor's library did not write; what does not
 *                    fit is cut off. Not touched when the text was not told. NULL makes the call fail.
 * @param len         Bytes of room. 0 and less make the call fail.
 * @return Whether the server told it.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL GetBvhHeader(SOCKET_REF sockRef, int avatarIndex, char *data, int len);

#ifdef NEURONDATAREADER_B12

/**
 * Called with every answer to a command on a data connection, on the connection's receive thread, between its frames.
 *
 *   Cmd_BoneSize           data: pack->DataCount entries of CmdResponseBoneSize
 *   Cmd_BvhInheritanceTxt  data: pack->DataCount bytes of text, without a zero byte
 *   Cmd_DataFrequency      pack->CmdParaments: two int32_t, avatar and frames per second
 *   Cmd_CombinationMode    pack->CmdParaments: two int32_t, avatar and SensorCombinationModes
 *   Cmd_AvatarCount        pack->CmdParaments: int32_t, number of avatars
 *   others                 not known
 *
 * @param customedObj What was registered with the callback.
 * @param sender      The connection.
 * @param pack        The answer's header. Valid during the call.
 * @param data        What follows the header, NULL when nothing does. Valid during the call.
 */
typedef void (CALLBACK *CommandDataReceived)(void *customedObj, SOCKET_REF sender, CommandPack *pack, void *data);

/**
 * Sets the callback of answers to commands on data connections: as BRRegisterFrameDataCallback.
 *
 * @param customedObj Passed to the callback as it is.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterCommandDataCallback(void *customedObj, CommandDataReceived handle);

/**
 * Asks for a value that is not an avatar's own. Only servers of the time of b11 and b12 answer.
 *
 * @param sockRef A TCP connection of BRConnectTo.
 * @param cmdId   What to ask for.
 * @return 1 when the request was sent, otherwise 0. The answer comes to the callback.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRCommandFetchDataFromServer(SOCKET_REF sockRef, CmdId cmdId);

/**
 * Asks for a value of an avatar.
 *
 * @param sockRef     A TCP connection of BRConnectTo.
 * @param avatarIndex Number of the avatar, from 0.
 * @param cmdId       What to ask for.
 * @return 1 when the request was sent, otherwise 0. The answer comes to the callback.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRCommandFetchAvatarDataFromServer(SOCKET_REF sockRef, int avatarIndex, CmdId cmdId);

/**
 * Asks the server to send a value whenever it changes.
 *
 * @param sockRef A TCP connection of BRConnectTo.
 * @param cmdId   What to watch.
 * @return 1 when the request was sent, otherwise 0.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRRegisterAutoSyncParmeter(SOCKET_REF sockRef, CmdId cmdId);

/**
 * Asks the server to send a value no more by itself.
 *
 * @param sockRef A TCP connection of BRConnectTo.
 * @param cmdId   What was watched.
 * @return 1 when the request was sent, otherwise 0.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRUnregisterAutoSyncParmeter(SOCKET_REF sockRef, CmdId cmdId);

#endif

/* Ours: not in the vendor's library. */

/** Layout of the headers that the callback of BVH frames is given. */
typedef enum _BRHeaderLayout {
    BR_HEADER_NEW, /**< BvhDataHeader of b15 to b18. */
    BR_HEADER_OLD  /**< BvhDataHeader of b10 to b12, which is that of NEURONDATAREADER_B12. */
} BRHeaderLayout;

/**
 * Chooses the header layout for the process, from the next frame on, whatever the servers send. The default is BR_HEADER_NEW; the environment variable
 * NEURONDATAREADER_HEADER=b12, read at the first call, makes it BR_HEADER_OLD for programs that cannot be compiled again.
 *
 * @param layout The layout. Other values change nothing but the last error.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRSetHeaderLayout(BRHeaderLayout layout);

#ifdef NEURONDATAREADER_B12

/** What BRRegisterFrameDataCallback is in a program with NEURONDATAREADER_B12: chooses the layout that the program's structs have, too. */
static __inline void BRRegisterOldFrameDataCallback(void *customedObj, FrameDataReceived handle)
{
    BRSetHeaderLayout(BR_HEADER_OLD);
    BRRegisterFrameDataCallback(customedObj, handle);
}
#define BRRegisterFrameDataCallback BRRegisterOldFrameDataCallback

#endif

#ifdef __cplusplus
}
#endif

#endif
