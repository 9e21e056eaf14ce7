using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using NeuronDataReaderManaged;

namespace UserScripts
{
    // A script for the managed reader of the Unity integration: a source for each connection, actors by avatar, no status query.
    public class ManagedScript
    {
        private static readonly Dictionary<IntPtr, ManagedScript> sources = new Dictionary<IntPtr, ManagedScript>();

        private readonly Dictionary<int, float[]> actors = new Dictionary<int, float[]>();
        private IntPtr socketReference;

        public int FrameCount;
        public string Message;
        public SocketStatus Status = SocketStatus.CS_OffWork;

        public static bool Supports(ManagedScript script)
        {
            return NeuronDataReader.frameDataReceivedCallback == new FrameDataReceived(OnFrameDataReceived)
                && sources.ContainsValue(script);
        }

        public static ManagedScript Connect(string address, int port, int commandServerPort, bool udp)
        {
            if (sources.Count == 0)
            {
                NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, OnFrameDataReceived);
                NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, OnSocketStatusChanged);
            }

            IntPtr reference = udp ? NeuronDataReader.BRStartUDPServiceAt(port) : NeuronDataReader.BRConnectTo(address, port);
            if (reference == IntPtr.Zero)
                return null;

            if (commandServerPort > 0)
                NeuronDataReader.BRCommandFetchDataFromServer(reference, CmdId.Cmd_AvatarCount);

            ManagedScript source = new ManagedScript();
            source.socketReference = reference;
            lock (sources)
                sources.Add(reference, source);
            return source;
        }

        public void Disconnect()
        {
            NeuronDataReader.BRCloseSocket(socketReference);
            lock (sources)
                sources.Remove(socketReference);
            if (sources.Count == 0)
            {
                NeuronDataReader.frameDataReceivedCallback -= OnFrameDataReceived;
                NeuronDataReader.socketStatusChangedCallback -= OnSocketStatusChanged;
            }
        }

        public float[] GetData(int avatar)
        {
            lock (actors)
                return actors.ContainsKey(avatar) ? actors[avatar] : null;
        }

        private static void OnFrameDataReceived(IntPtr customObject, IntPtr sockRef, IntPtr header, IntPtr data)
        {
            ManagedScript source;
            lock (sources)
            {
                if (!sources.TryGetValue(sockRef, out source))
                    return;
            }

            BvhDataHeader dataHeader = new BvhDataHeader();
            dataHeader = (BvhDataHeader)Marshal.PtrToStructure(header, typeof(BvhDataHeader));
            source.OnFrame(dataHeader, data);
        }

        private static void OnSocketStatusChanged(IntPtr customObject, IntPtr sockRef, SocketStatus status, string msg)
        {
            ManagedScript source;
            lock (sources)
            {
                if (!sources.TryGetValue(sockRef, out source))
                    return;
            }

            source.Status = status;
            source.Message = msg;
        }

        private void OnFrame(BvhDataHeader header, IntPtr data)
        {
            float[] values = new float[(int)header.DataCount];
            Marshal.Copy(data, values, 0, values.Length);
            lock (actors)
            {
                actors[(int)header.AvatarIndex] = values;
                FrameCount++;
            }
        }
    }
}
