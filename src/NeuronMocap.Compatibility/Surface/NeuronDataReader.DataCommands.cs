using NeuronMocap.Compatibility;

namespace NeuronDataReaderWraper;

/// <content>
/// Commands on the data connection, which servers of the time of b11 and b12 answer (protocol.md section 7). The answers come to the callback of
/// <see cref="BRRegisterCommandDataCallback"/>. The result true only means that the request was sent.
/// </content>
public partial class NeuronDataReader
{
    /// <summary>Asks for a value that does not belong to an avatar.</summary>
    /// <param name="sockRef">A TCP connection.</param>
    /// <param name="cmdId">The value to ask for.</param>
    /// <returns>Whether the request was sent. False if the handle is not an open TCP connection.</returns>
    public static bool BRCommandFetchDataFromServer(IntPtr sockRef, CmdId cmdId) => VendorFunctions.Fetch(sockRef, (int)cmdId, avatar: 0);

    /// <summary>Asks for a value of an avatar.</summary>
    /// <param name="sockRef">A TCP connection.</param>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <param name="cmdId">The value to ask for.</param>
    /// <returns>Whether the request was sent. False if the handle is not an open TCP connection.</returns>
    public static bool BRCommandFetchAvatarDataFromServer(IntPtr sockRef, int avatarIndex, CmdId cmdId) =>
        VendorFunctions.Fetch(sockRef, (int)cmdId, avatarIndex);

    /// <summary>Asks the server to send a value whenever it changes.</summary>
    /// <param name="sockRef">A TCP connection.</param>
    /// <param name="cmdId">The value to register for.</param>
    /// <returns>Whether the request was sent. False if the handle is not an open TCP connection.</returns>
    public static bool BRRegisterAutoSyncParmeter(IntPtr sockRef, CmdId cmdId) => VendorFunctions.Register(sockRef, (int)cmdId);

    /// <summary>Asks the server to stop sending a value whenever it changes.</summary>
    /// <param name="sockRef">A TCP connection.</param>
    /// <param name="cmdId">The value that was registered.</param>
    /// <returns>Whether the request was sent. False if the handle is not an open TCP connection.</returns>
    public static bool BRUnregisterAutoSyncParmeter(IntPtr sockRef, CmdId cmdId) => VendorFunctions.Unregister(sockRef, (int)cmdId);
}
