// A wrapper around the native library with the shape of b15's, as in many Unity projects.
using System;
using System.Runtime.InteropServices;

namespace NeuronDataReaderWraper
{
    [UnmanagedFunctionPointer(CallingConvention.StdCall)]
    public delegate void FrameDataReceived(IntPtr customObject, IntPtr sockRef, IntPtr bvhDataHeader, IntPtr data);

    [UnmanagedFunctionPointer(CallingConvention.StdCall)]
    public delegate void SocketStatusChanged(IntPtr customObject, IntPtr sockRef, SocketStatus status, [MarshalAs(UnmanagedType.LPStr)] string msg);

    public enum SocketStatus
    {
        CS_Running,
        CS_Starting,
        CS_OffWork,
    }

    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    public struct DataVersion
    {
        public byte BuildNumb;
        public byte Revision;
        public byte Minor;
        public byte Major;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    public struct BvhDataHeader
    {
        public ushort Token1;
        public DataVersion DataVersion;
        public ushort DataCount;
        public byte bWithDisp;
        public byte bWithReference;
        public uint AvatarIndex;
        [MarshalAs(UnmanagedType.ByValTStr, SizeConst = 32)]
        public string AvatarName;
        public uint FrameIndex;
        public uint Reserved;
        public uint Reserved1;
        public uint Reserved2;
        public ushort Token2;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    public struct CalcDataHeader
    {
        public ushort Token1;
        public DataVersion DataVersion;
        public uint DataCount;
        public uint AvatarIndex;
        [MarshalAs(UnmanagedType.ByValTStr, SizeConst = 32)]
        public string AvatarName;
        public uint FrameIndex;
        public uint Reserved1;
        public uint Reserved2;
        public uint Reserved3;
        public ushort Token2;
    }

    public class NeuronDataReader
    {
        private const string Library = "NeuronDataReader";

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void BRRegisterFrameDataCallback(IntPtr customedObj, FrameDataReceived handle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void BRRegisterCalculationDataCallback(IntPtr customedObj, FrameDataReceived handle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void BRRegisterSocketStatusCallback(IntPtr customedObj, SocketStatusChanged handle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr BRConnectTo(string serverIP, int nPort);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr BRStartUDPServiceAt(int nPort);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern SocketStatus BRGetSocketStatus(IntPtr sockRef);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void BRCloseSocket(IntPtr sockRef);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        private static extern IntPtr BRGetLastErrorMessage();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern IntPtr BRConnectCmd(string serverIP, int nPort);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        [return: MarshalAs(UnmanagedType.I1)]
        public static extern bool ZeroOut(IntPtr sockRef, int avatarIndex);

        public static string strBRGetLastErrorMessage()
        {
            return Marshal.PtrToStringAnsi(BRGetLastErrorMessage());
        }
    }
}
