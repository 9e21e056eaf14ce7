using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using NeuronDataReaderWraper;

// A script for the native wrapper of b15: header with Token1 and 16-bit fields, calculation data, no commands. Static, like many such scripts.
public static class W2Script
{
    private static FrameDataReceived frameHandler;
    private static FrameDataReceived calculationHandler;
    private static SocketStatusChanged statusHandler;

    public static readonly List<ReceivedFrame> Frames = new List<ReceivedFrame>();
    public static readonly List<ReceivedFrame> CalculationFrames = new List<ReceivedFrame>();
    public static readonly Dictionary<IntPtr, string> Connections = new Dictionary<IntPtr, string>();
    public static readonly List<string> Log = new List<string>();

    public static void Init(IntPtr frameObject, IntPtr calculationObject)
    {
        Frames.Clear();
        CalculationFrames.Clear();
        Connections.Clear();
        Log.Clear();
        frameHandler = OnFrame;
        calculationHandler = OnCalculation;
        statusHandler = OnStatus;
        NeuronDataReader.BRRegisterFrameDataCallback(frameObject, frameHandler);
        NeuronDataReader.BRRegisterCalculationDataCallback(calculationObject, calculationHandler);
        NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, statusHandler);
    }

    public static IntPtr Connect(string ip, int port)
    {
        return Remember(NeuronDataReader.BRConnectTo(ip, port), ip + ":" + port);
    }

    public static IntPtr Listen(int port)
    {
        return Remember(NeuronDataReader.BRStartUDPServiceAt(port), "udp:" + port);
    }

    public static bool IsRunning(IntPtr connection)
    {
        return NeuronDataReader.BRGetSocketStatus(connection) == SocketStatus.CS_Running;
    }

    public static void CloseAll()
    {
        foreach (IntPtr connection in Connections.Keys)
            NeuronDataReader.BRCloseSocket(connection);
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
    }

    public static int Count(List<ReceivedFrame> frames)
    {
        lock (frames)
            return frames.Count;
    }

    private static IntPtr Remember(IntPtr connection, string name)
    {
        if (connection == IntPtr.Zero)
        {
            lock (Log)
                Log.Add(NeuronDataReader.strBRGetLastErrorMessage());
        }
        else if (!Connections.ContainsKey(connection))
        {
            Connections.Add(connection, name);
        }

        return connection;
    }

    private static void OnFrame(IntPtr customObject, IntPtr sockRef, IntPtr dataHeader, IntPtr data)
    {
        BvhDataHeader header = (BvhDataHeader)Marshal.PtrToStructure(dataHeader, typeof(BvhDataHeader));
        float[] values = new float[header.DataCount];
        Marshal.Copy(data, values, 0, (int)header.DataCount);
        ReceivedFrame frame = new ReceivedFrame();
        frame.Connection = sockRef;
        frame.CustomObject = customObject.ToInt64();
        frame.Avatar = (int)header.AvatarIndex;
        frame.AvatarName = header.AvatarName;
        frame.FrameIndex = header.FrameIndex;
        frame.WithDisplacement = header.bWithDisp != 0;
        frame.WithReference = header.bWithReference != 0;
        frame.Version = Version(header.DataVersion);
        frame.Values = values;
        if (header.Token1 == 0xDDFF && header.Token2 == 0xEEFF)
        {
            lock (Frames)
                Frames.Add(frame);
        }
    }

    private static void OnCalculation(IntPtr customObject, IntPtr sockRef, IntPtr dataHeader, IntPtr data)
    {
        CalcDataHeader header = (CalcDataHeader)Marshal.PtrToStructure(dataHeader, typeof(CalcDataHeader));
        ReceivedFrame frame = new ReceivedFrame();
        frame.Connection = sockRef;
        frame.CustomObject = customObject.ToInt64();
        frame.Avatar = (int)header.AvatarIndex;
        frame.AvatarName = header.AvatarName;
        frame.FrameIndex = header.FrameIndex;
        frame.Version = Version(header.DataVersion);
        frame.Values = new float[header.DataCount];
        Marshal.Copy(data, frame.Values, 0, frame.Values.Length);
        if (header.Token1 == 0x88FF && header.Token2 == 0x99FF)
        {
            lock (CalculationFrames)
                CalculationFrames.Add(frame);
        }
    }

    private static void OnStatus(IntPtr customObject, IntPtr sockRef, SocketStatus status, string msg)
    {
        lock (Log)
            Log.Add(status + " " + msg);
    }

    private static string Version(DataVersion version)
    {
        return version.Major + "." + version.Minor + "." + version.Revision + "." + version.BuildNumb;
    }
}
