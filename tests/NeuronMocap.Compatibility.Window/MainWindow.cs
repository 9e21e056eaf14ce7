using System;
using System.Drawing;
using System.Runtime.InteropServices;
using System.Windows.Forms;
using NeuronDataReaderWraper;

public class MainWindow : Form
{
    private FrameDataReceived _DataReceived;
    private SocketStatusChanged _SocketStatusChanged;
    private BvhDataHeader _bvhHeader;
    private float[] _valuesBuffer = new float[354];
    private IntPtr sockTCPRef = IntPtr.Zero;
    private int _frameCount;

    private readonly TextBox txtIP = new TextBox();
    private readonly TextBox txtPort = new TextBox();
    private readonly Button btnConnect = new Button();
    private readonly Label lblStatus = new Label();
    private readonly Label lblFrames = new Label();
    private readonly Label lblAvatar = new Label();
    private readonly Label lblHips = new Label();

    public MainWindow(string ip, string port)
    {
        Text = "NeuronDataReader";
        ClientSize = new Size(420, 200);
        txtIP.Text = ip;
        txtPort.Text = port;
        btnConnect.Text = "Connect";
        btnConnect.Click += btnConnect_Click;
        AcceptButton = btnConnect;
        Control[] controls = { txtIP, txtPort, btnConnect, lblStatus, lblFrames, lblAvatar, lblHips };
        for (int i = 0; i < controls.Length; i++)
            controls[i].SetBounds(10, 10 + 26 * i, 400, 24);
        Controls.AddRange(controls);
        Load += Window_Loaded;
        FormClosed += Window_Closed;
    }

    private void Window_Loaded(object sender, EventArgs e)
    {
        _DataReceived = new FrameDataReceived(bvhDataReceived);
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, _DataReceived);
        _SocketStatusChanged = new SocketStatusChanged(socketStatusChanged);
        NeuronDataReader.BRRegisterSocketStatusCallback(IntPtr.Zero, _SocketStatusChanged);
    }

    private void Window_Closed(object sender, FormClosedEventArgs e)
    {
        if (sockTCPRef != IntPtr.Zero)
        {
            NeuronDataReader.BRCloseSocket(sockTCPRef);
            sockTCPRef = IntPtr.Zero;
        }
    }

    private void btnConnect_Click(object sender, EventArgs e)
    {
        if (NeuronDataReader.BRGetSocketStatus(sockTCPRef) == SocketStatus.CS_Running)
        {
            NeuronDataReader.BRCloseSocket(sockTCPRef);
            sockTCPRef = IntPtr.Zero;
            btnConnect.Text = "Connect";
            return;
        }

        sockTCPRef = NeuronDataReader.BRConnectTo(txtIP.Text, int.Parse(txtPort.Text));
        if (sockTCPRef == IntPtr.Zero)
            lblStatus.Text = NeuronDataReader.strBRGetLastErrorMessage();
        else
            btnConnect.Text = "Disconnect";
    }

    // The thread of the connection.
    private void bvhDataReceived(IntPtr customObject, IntPtr sockRef, IntPtr header, IntPtr data)
    {
        _bvhHeader = (BvhDataHeader)Marshal.PtrToStructure(header, typeof(BvhDataHeader));
        if (_bvhHeader.DataCount != _valuesBuffer.Length)
            _valuesBuffer = new float[_bvhHeader.DataCount];
        Marshal.Copy(data, _valuesBuffer, 0, (int)_bvhHeader.DataCount);
        Invoke(new MethodInvoker(ShowFrame));
    }

    private void socketStatusChanged(IntPtr customObject, IntPtr sockRef, SocketStatus status, string msg)
    {
        Invoke(new MethodInvoker(delegate { lblStatus.Text = status + ": " + msg.Trim(); }));
    }

    private void ShowFrame()
    {
        _frameCount++;
        lblFrames.Text = _frameCount + " frames";
        lblAvatar.Text = _bvhHeader.AvatarName + ", frame " + _bvhHeader.FrameIndex;
        lblHips.Text = "Hips " + _valuesBuffer[0] + " " + _valuesBuffer[1] + " " + _valuesBuffer[2];
    }
}
