/**
 * @file
 * The functions of NeuronDataReader, for C99 and C++98 and newer. Include it before or after windows.h. DataType.h describes how programs for b10 to
 * b12 include it.
 *
 * Order of calls: register callbacks, connect, and close at the end. The library does not delay the exit of a program that does not close.
 *
 * Threads: all functions are thread-safe and may be called from callbacks. They throw no exceptions. They ignore NULL, closed and foreign handles.
 * Callbacks of a connection or UDP service run one at a time, on its receive thread. Each of the first sixteen TCP connections has its own receive
 * thread; further ones use any free thread of the library. Callbacks of two connections may run at the same time. While a callback runs, its
 * connection reads nothing. A slow callback therefore makes the server wait or lose frames. No C++ exception and no longjmp may leave a callback.
 *
 * Text is UTF-8.
 */
#ifndef NEURONDATAREADER_H
#define NEURONDATAREADER_H

#include "DataType.h"

/* DataType.h defines the calling convention of callbacks. */
#ifdef _WIN32
#define NEURONDATAREADER_API __declspec(dllimport)
#define NEURONDATAREADER_CALL __cdecl
#else
#define NEURONDATAREADER_API
#define NEURONDATAREADER_CALL
#endif

/** Older name of NEURONDATAREADER_API. */
#ifndef BDR_API
#define BDR_API NEURONDATAREADER_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Called with every frame of BVH data, on the receive thread of its connection or service. The first call may come before BRConnectTo has returned.
 *
 * Positions are in centimetres and angles in degrees. Each rotation is relative to the parent bone. Its angles are in the rotation order of the
 * server, YXZ by default. Order of the bones: manual, appendix A.
 *
 * @param customedObj The object that was registered with the callback.
 * @param sender      The connection or service.
 * @param header      Describes the floats. Valid during the call; the callback may change it. Aligned to 16 bytes.
 * @param data        header->DataCount floats, as sent. Valid during the call; the callback may change them. Aligned to 16 bytes.
 */
#ifdef NEURONDATAREADER_B10
typedef void (CALLBACK *FrameDataReceived)(void *customedObj, SOCKET_REF sender, BvhDataHeader *header, float *data);
#else
typedef void (CALLBACK *FrameDataReceived)(void *customedObj, SOCKET_REF sender, BvhDataHeaderEx *header, float *data);
#endif

/**
 * Called with every frame of calculation data, on the receive thread of its connection or service.
 *
 * Each bone has 16 floats: position x y z in metres, velocity x y z, orientation w x y z, acceleration x y z and angular velocity x y z. Acceleration
 * and angular velocity are in the sensor's own axes. The data holds 21 bones, two floats for the left and right foot, and 38 bones of the hands. The
 * float of a foot is 1 while the foot touches the ground. Order of the bones: manual, appendix C.
 *
 * @param customedObj The object that was registered with the callback. The vendor's library passed the object of the BVH callback.
 * @param sender      The connection or service.
 * @param header      Describes the floats. Valid during the call; the callback may change it. Aligned to 16 bytes.
 * @param data        header->DataCount floats, as sent. Valid during the call; the callback may change them. Aligned to 16 bytes.
 */
typedef void (CALLBACK *CalculationDataReceived)(void *customedObj, SOCKET_REF sender, CalcDataHeader *header, float *data);

/**
 * Called when the status of a TCP connection changes. The texts are the vendor's, letter by letter. UDP services and command connections do not call it.
 *
 * On the thread that connects:
 *   "Connecting to {ip}:{port} ...\n" (starting), then
 *   "Successfully connected to '{ip}:{port}'." (running), or
 *   "Failed to connect to '{ip}:{port}'." (starting) and "Service is stoped\n" (off work).
 * When the server ends the connection, on a thread of the library after the last frame:
 *   "Failed to read data." and "Data thread exited.\n" (both running, although BRGetSocketStatus then returns off work).
 * On the thread that closes:
 *   "Service is stoped\n" (off work).
 *
 * @param customedObj The object that was registered with the callback.
 * @param sender      The connection: the value that BRConnectTo returns later if it succeeds.
 * @param status      The new status.
 * @param message     A description. Valid during the call.
 */
typedef void (CALLBACK *SocketStatusChanged)(void *customedObj, SOCKET_REF sender, SocketStatus status, char *message);

/**
 * Sets the callback of BVH frames. There is one for the process. A call replaces the callback together with its object, from the next frame on. A
 * callback that is already running may still use the old object.
 *
 * @param customedObj The object to pass to the callback.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterFrameDataCallback(void *customedObj, FrameDataReceived handle);

/**
 * Sets the callback of calculation frames; see BRRegisterFrameDataCallback.
 *
 * @param customedObj The object to pass to the callback.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterCalculationDataCallback(void *customedObj, CalculationDataReceived handle);

/**
 * Sets the callback of status changes; see BRRegisterFrameDataCallback.
 *
 * @param customedObj The object to pass to the callback.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterSocketStatusCallback(void *customedObj, SocketStatusChanged handle);

/**
 * Connects to a server over TCP. Returns when the connection is open or has failed, at most after about 5 s.
 *
 * @param serverIP Address or name of the server. The vendor's library ended the process if it could not find the name.
 * @param nPort    Port of the server, 1 to 65535. By default 7001 for BVH and 7003 for calculation data.
 * @return The connection, or an existing connection to the same address and port. A call from a status callback that reports the start of a connection
 *         also returns that connection, although it is still starting. NULL on failure; BRGetLastErrorMessage then gives the reason.
 */
NEURONDATAREADER_API SOCKET_REF NEURONDATAREADER_CALL BRConnectTo(const char *serverIP, int nPort);

/**
 * Starts to receive over UDP, from any sender. Other programs that share the port may receive on it, too. The system decides which program gets a
 * datagram.
 *
 * @param nPort Port to receive on, 1 to 65535. 0 lets the system choose a port, which the program cannot find out.
 * @return The service; every call starts a new one. NULL on failure; BRGetLastErrorMessage then gives the reason.
 */
NEURONDATAREADER_API SOCKET_REF NEURONDATAREADER_CALL BRStartUDPServiceAt(int nPort);

/**
 * Closes a connection, UDP service or command connection. After it returns, no callback of that connection starts. It waits at most 75 ms for a
 * running callback, because the callback may wait for the thread that closes. The memory of that callback stays valid until the callback ends.
 * Closing NULL or a closed handle does nothing.
 *
 * @param sockRef The handle to close.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRCloseSocket(SOCKET_REF sockRef);

/**
 * Gets the status of a connection, UDP service or command connection.
 *
 * @param sockRef A handle.
 * @return The status. CS_OffWork for NULL, for a closed handle, and after the server has ended the connection. The last case differs from the
 *         vendor's library.
 */
NEURONDATAREADER_API SocketStatus NEURONDATAREADER_CALL BRGetSocketStatus(SOCKET_REF sockRef);

/**
 * Gets the last error of the process as readable text. It is "No error." at first. A success does not clear it, and all threads share it.
 *
 * @return Always the same memory, never NULL, with a zero byte at its end at any moment. The next error of any thread overwrites it, so copy the text
 *         to keep it. Do not change or free it.
 */
NEURONDATAREADER_API char *NEURONDATAREADER_CALL BRGetLastErrorMessage(void);

/**
 * Opens a command connection to a server: manual section 2.3.9. It calls no status callback.
 *
 * @param serverIP Address or name of the server.
 * @param nPort    Command port of the server, 1 to 65535. It is not a data port.
 * @return The connection, for the functions below, or an existing one to the same address and port. NULL on failure, at most after about 5 s;
 *         BRGetLastErrorMessage then gives the reason.
 */
NEURONDATAREADER_API SOCKET_REF NEURONDATAREADER_CALL BRConnectCmd(const char *serverIP, int nPort);

/**
 * Asks the server to zero out an avatar. It is not documented whether this changes the direction, the position or both.
 *
 * Like all commands, it returns when the server has answered, or after 3 s with false. After a failure you can still use the connection; it
 * reconnects automatically.
 *
 * @param sockRef     A command connection. For any other handle the result is false, and nothing is sent.
 * @param avatarIndex Index of the avatar, from 0.
 * @return Whether the server confirmed it.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL ZeroOut(SOCKET_REF sockRef, int avatarIndex);

/**
 * Asks the server to zero out all avatars; see ZeroOut.
 *
 * @param sockRef A command connection.
 * @return Whether the server confirmed it.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL ZeroOutAll(SOCKET_REF sockRef);

/**
 * Asks for the rotation order of the server's BVH data.
 *
 * @param sockRef A command connection.
 * @param order   Receives the order, or RO_Unknown if the server sent none. NULL makes the call fail.
 * @return Whether the server sent the order. An order that does not exist does not count.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL GetBvhRotation(SOCKET_REF sockRef, RotateOrders *order);

/**
 * Asks for the dimensions of an avatar's body.
 *
 * @param sockRef     A command connection.
 * @param avatarIndex Index of the avatar, from 0.
 * @param dimensions  Receives the dimensions in metres, or zeros if the server sent none. NULL makes the call fail.
 * @return Whether the server sent all of them.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL GetBoneSize(SOCKET_REF sockRef, int avatarIndex, BoneDimension *dimensions);

/**
 * The same function as GetBoneSize, with the name in the heading of the manual's section 2.3.13.
 *
 * @param sockRef     A command connection.
 * @param avatarIndex Index of the avatar, from 0.
 * @param dimensions  Receives the dimensions in metres, or zeros if the server sent none. NULL makes the call fail.
 * @return Whether the server sent all of them.
 */
NEURONDATAREADER_API bool NEURONDATAREADER_CALL BRGetBoneSize(SOCKET_REF sockRef, int avatarIndex, BoneDimension *dimensions);

/**
 * Asks for the BVH header of an avatar: the text up to the motion data, about 10,000 bytes.
 *
 * @param sockRef     A command connection.
 * @param avatarIndex Index of the avatar, from 0.
 * @param data        Room for len bytes. Receives the text and, if there is room, a zero byte. The vendor's library did not write the zero byte. Text
 *                    that does not fit is cut off. If the server sent no text, the memory is unchanged. NULL makes the call fail.
 * @param len         Size of the room in bytes. 0 or less makes the call fail.
 * @return Whether the server sent the text.
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
 *   others                 unknown
 *
 * @param customedObj The object that was registered with the callback.
 * @param sender      The connection.
 * @param pack        Header of the answer. Valid during the call.
 * @param data        Data after the header, or NULL if there is none. Valid during the call.
 */
typedef void (CALLBACK *CommandDataReceived)(void *customedObj, SOCKET_REF sender, CommandPack *pack, void *data);

/**
 * Sets the callback of answers to commands on data connections; see BRRegisterFrameDataCallback.
 *
 * @param customedObj The object to pass to the callback.
 * @param handle      The callback, or NULL for none.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRRegisterCommandDataCallback(void *customedObj, CommandDataReceived handle);

/**
 * Asks for a value that does not belong to an avatar. Only servers of the time of b11 and b12 answer.
 *
 * @param sockRef A TCP connection of BRConnectTo.
 * @param cmdId   The value to ask for.
 * @return 1 if the request was sent, otherwise 0. The answer comes to the callback.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRCommandFetchDataFromServer(SOCKET_REF sockRef, CmdId cmdId);

/**
 * Asks for a value of an avatar.
 *
 * @param sockRef     A TCP connection of BRConnectTo.
 * @param avatarIndex Index of the avatar, from 0.
 * @param cmdId       The value to ask for.
 * @return 1 if the request was sent, otherwise 0. The answer comes to the callback.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRCommandFetchAvatarDataFromServer(SOCKET_REF sockRef, int avatarIndex, CmdId cmdId);

/**
 * Asks the server to send a value whenever it changes.
 *
 * @param sockRef A TCP connection of BRConnectTo.
 * @param cmdId   The value to register for.
 * @return 1 if the request was sent, otherwise 0.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRRegisterAutoSyncParmeter(SOCKET_REF sockRef, CmdId cmdId);

/**
 * Asks the server to stop sending a value whenever it changes.
 *
 * @param sockRef A TCP connection of BRConnectTo.
 * @param cmdId   The value that was registered.
 * @return 1 if the request was sent, otherwise 0.
 */
NEURONDATAREADER_API int NEURONDATAREADER_CALL BRUnregisterAutoSyncParmeter(SOCKET_REF sockRef, CmdId cmdId);

#endif

/* Not in the vendor's library. */

/** Layout of the headers that the callback of BVH frames receives. */
typedef enum _BRHeaderLayout {
    BR_HEADER_NEW, /**< BvhDataHeader of b15 to b18. */
    BR_HEADER_OLD  /**< BvhDataHeader of b10 to b12, which is that of NEURONDATAREADER_B12. */
} BRHeaderLayout;

/**
 * Sets the header layout for the process, from the next frame on. It does not depend on what the servers send. The default is BR_HEADER_NEW. The
 * environment variable NEURONDATAREADER_HEADER=b12, read at the first call, changes the default to BR_HEADER_OLD for programs that cannot be
 * recompiled.
 *
 * @param layout The layout. Other values only set the last error.
 */
NEURONDATAREADER_API void NEURONDATAREADER_CALL BRSetHeaderLayout(BRHeaderLayout layout);

#ifdef NEURONDATAREADER_B12

/** Replaces BRRegisterFrameDataCallback in programs with NEURONDATAREADER_B12. It also sets the header layout of the program's structs. */
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
