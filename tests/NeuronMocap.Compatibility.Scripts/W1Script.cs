using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using NeuronDataReaderWraper;

// A script for the native wrapper of b10 to b14: header with HeaderToken1 and 32-bit fields, commands on the data connection.
public class W1Script
{
    private readonly FrameDataReceived dataReceived;
    private readonly CommandDataReceived commandReceived;
    private readonly SocketStatusChanged statusChanged;
    private readonly Dictionary<IntPtr, List<ReceivedFrame>> framesOf = new Dictionary<IntPtr, List<ReceivedFrame>>();
    private readonly List<string> log = new List<string>();
    private readonly Dictionary<CmdId, byte[]> parameters = new Dictionary<CmdId, byte[]>();
    private BvhDataHeader header;

    public readonly List<CmdResponseBoneSize> BoneSizes = new List<CmdResponseBoneSize>();
    public string BvhText;
    public IntPtr Socket = IntPtr.Zero;

    public W1Script()
    {
        dataReceived = new FrameDataReceived(OnFrameDataReceived);
        commandReceived = new CommandDataReceived(OnCommandDataReceived);
        statusChanged = new SocketStatusChanged(OnSocketStatusChanged);
        NeuronDataReader.BRRegisterFrameDataCallback(new IntPtr(71), dataReceived);
        NeuronDataReader.BRRegisterCommandDataCallback(IntPtr.Zero, commandReceived);
        NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, statusChanged);
    }

    public bool Connect(string ip, string port)
    {
        if (NeuronDataReader.BRGetSocketStatus(Socket) == SocketStatus.CS_Running)
        {
            NeuronDataReader.BRCloseSocket(Socket);
            Socket = IntPtr.Zero;
        }

        Socket = NeuronDataReader.BRConnectTo(ip, int.Parse(port));
        if (Socket == IntPtr.Zero)
        {
            lock (log)
                log.Add(NeuronDataReader.strBRGetLastErrorMessage());
            return false;
        }

        return true;
    }

    public bool AskForEverything(int avatar)
    {
        return NeuronDataReader.BRCommandFetchAvatarDataFromServer(Socket, avatar, CmdId.Cmd_BoneSize)
            && NeuronDataReader.BRCommandFetchAvatarDataFromServer(Socket, avatar, CmdId.Cmd_DataFrequency)
            && NeuronDataReader.BRCommandFetchAvatarDataFromServer(Socket, avatar, CmdId.Cmd_CombinationMode)
            && NeuronDataReader.BRCommandFetchAvatarDataFromServer(Socket, avatar, CmdId.Cmd_BvhInheritance)
            && NeuronDataReader.BRRegisterAutoSyncParmeter(Socket, CmdId.Cmd_CombinationMode)
            && NeuronDataReader.BRUnregisterAutoSyncParmeter(Socket, CmdId.Cmd_CombinationMode)
            && NeuronDataReader.BRCommandFetchDataFromServer(Socket, CmdId.Cmd_AvatarCount);
    }

    public ReceivedFrame[] FramesOf(IntPtr connection)
    {
        lock (framesOf)
            return framesOf.ContainsKey(connection) ? framesOf[connection].ToArray() : new ReceivedFrame[0];
    }

    public string[] Lines()
    {
        lock (log)
            return log.ToArray();
    }

    // Null before the answer. Only some answers contain numbers.
    public int[] NumbersOf(CmdId command)
    {
        lock (parameters)
        {
            if (!parameters.ContainsKey(command))
                return null;
            byte[] bytes = parameters[command];
            return new int[] { BitConverter.ToInt32(bytes, 0), BitConverter.ToInt32(bytes, 4) };
        }
    }

    public void Close()
    {
        NeuronDataReader.BRCloseSocket(Socket);
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterCommandDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
    }

    private void OnFrameDataReceived(IntPtr customObject, IntPtr sockRef, IntPtr dataHeader, IntPtr data)
    {
        header = (BvhDataHeader)Marshal.PtrToStructure(dataHeader, typeof(BvhDataHeader));
        if (header.HeaderToken1 != 0xDDFF || header.HeaderToken2 != 0xEEFF)
            return;

        UInt32 count = header.DataCount;
        UInt32 withDisplacement = header.bWithDisp;
        ReceivedFrame frame = new ReceivedFrame();
        frame.Connection = sockRef;
        frame.CustomObject = customObject.ToInt64();
        frame.Avatar = (int)header.AvatarIndex;
        frame.AvatarName = header.AvatarName;
        frame.WithDisplacement = withDisplacement != 0;
        frame.WithReference = header.bWithReference == 1;
        frame.Values = new float[count];
        Marshal.Copy(data, frame.Values, 0, (int)header.DataCount);
        lock (framesOf)
        {
            if (!framesOf.ContainsKey(sockRef))
                framesOf.Add(sockRef, new List<ReceivedFrame>());
            framesOf[sockRef].Add(frame);
        }
    }

    private void OnCommandDataReceived(IntPtr customedObj, IntPtr sockRef, IntPtr cmdHeader, IntPtr cmdData)
    {
        CommandPack pack = (CommandPack)Marshal.PtrToStructure(cmdHeader, typeof(CommandPack));
        lock (parameters)
        {
            switch (pack.CommandId)
            {
                case CmdId.Cmd_BoneSize:
                    for (int i = 0; i < pack.DataCount; i++)
                    {
                        IntPtr entry = new IntPtr(cmdData.ToInt64() + (i * Marshal.SizeOf(typeof(CmdResponseBoneSize))));
                        BoneSizes.Add((CmdResponseBoneSize)Marshal.PtrToStructure(entry, typeof(CmdResponseBoneSize)));
                    }

                    break;
                case CmdId.Cmd_BvhInheritance:
                    BvhText = Marshal.PtrToStringAnsi(cmdData, (int)pack.DataCount);
                    break;
                default:
                    if (cmdData == IntPtr.Zero)
                        parameters[pack.CommandId] = pack.CmdParaments;
                    break;
            }
        }
    }

    private void OnSocketStatusChanged(IntPtr customObject, IntPtr sockRef, SocketStatus status, string msg)
    {
        lock (log)
            log.Add((int)status + " " + msg);
    }
}
