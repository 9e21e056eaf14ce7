using System;
using System.IO;
using System.Linq;
using System.Windows.Forms;
using NeuronMocap;
using NeuronMocap.Recording;
using NeuronMocap.Server;

/// <summary>Connects, shows what arrives, and records. All code of this class runs on the thread of the window.</summary>
internal sealed partial class MainWindow : Form
{
    private Broadcaster? _demo;
    private NeuronReader? _reader;
    private FrameDelivery? _delivery;
    private StreamRecorder? _recorder;
    private int? _selected;
    private int _shown;

    public MainWindow(string? address)
    {
        CreateControls();
        Disconnect();
        _connect.Click += (_, _) => ToggleConnection();
        _record.Click += (_, _) => ToggleRecording();
        _timer.Tick += (_, _) => ShowProgress();
        _timer.Start();
        // A recording ends with its reader. Dispose returns when the file is complete.
        FormClosed += (_, _) => { Disconnect(); _recorder?.Dispose(); _timer.Dispose(); };
        if (address is not null)
            Shown += (_, _) => ToggleConnection();
        _address.Text = address ?? "demo";
    }

    private void ToggleConnection()
    {
        bool connects = _reader is null;
        Disconnect();
        if (!connects)
            return;

        try
        {
            _demo = _address.Text is "demo" ? Broadcaster.StartDemo(avatars: 3, frameRate: 120) : null;
            _reader = new NeuronReader(NeuronReaderOptions.Parse(_demo is null ? _address.Text : $"{_demo.LocalEndPoint}"));
        }
        catch (Exception exception) when (exception is FormatException or NeuronException)
        {
            _status.Text = exception.Message;
            return;
        }

        // Handlers run on the thread that opens the delivery. A screen shows 60 images a second; rates and recordings still have every frame.
        _delivery = _reader.OpenDelivery(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest, MaxRate = 60 });
        _delivery.StatusChanged += status => (_status.Text, _skeleton.Enabled) = (status.Message, status.State == ConnectionState.Receiving);
        _delivery.MotionReceived += ShowFrame;
        _reader.Start();
        _connect.Text = "Disconnect";
        _record.Enabled = true;
    }

    // No handler of the delivery runs after this.
    private void Disconnect()
    {
        _delivery?.Dispose();
        _reader?.Dispose();
        _demo?.Dispose();
        (_demo, _reader, _delivery) = (null, null, null);
        _list.Items.Clear();
        _skeleton.Enabled = false;
        _status.Text = "Not connected";
        _rates.Text = "";
        _connect.Text = "Connect";
        _record.Enabled = false;
    }

    private void ShowFrame(MotionFrame frame)
    {
        if (frame.AvatarIndex != _selected)
            return;

        _skeleton.ShowPose(frame);
        _shown++;
    }

    private void ToggleRecording()
    {
        if (_recorder is not null)
        {
            _ = _recorder.StopAsync(); // does not wait for the disk; ShowProgress notices the end
            return;
        }

        string folder = Environment.GetFolderPath(Environment.SpecialFolder.MyDocuments);
        try
        {
            _recorder = _reader!.StartRecording(Path.Combine(folder, $"take-{DateTime.Now:yyyyMMdd-HHmmss}.nmrec"));
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            _recording.Text = exception.Message;
        }
    }

    // Four times a second.
    private void ShowProgress()
    {
        if (_reader is not null)
            ShowRates(_reader);
        if (_recorder is null)
            return;

        double seconds = _recorder.GetStatistics().Duration.TotalSeconds;
        bool hasEnded = _recorder.Completion.IsCompleted;
        _recording.Text = _recorder.Failure?.Message ?? $"{(hasEnded ? "Recorded" : "Recording")} {seconds:0.0} s to {_recorder.Path}";
        _record.Text = hasEnded ? "Record" : "Stop recording";
        _recorder = hasEnded ? null : _recorder;
    }

    private void ShowRates(NeuronReader reader)
    {
        AvatarStatistics[] avatars = [.. reader.GetAvatarStatistics().Where(static avatar => avatar.Kind == PacketKind.Motion)];
        while (_list.Items.Count < avatars.Length)
            _list.Items.Add("");
        while (_list.Items.Count > avatars.Length) // the reader forgets avatars to make room for others
            _list.Items.RemoveAt(_list.Items.Count - 1);
        for (int i = 0; i < avatars.Length; i++)
        {
            string text = $"{avatars[i].AvatarName}: {avatars[i].FrameRate:0} frames/s, {avatars[i].Lost} lost";
            if (!text.Equals(_list.Items[i]))
                _list.Items[i] = text;
        }

        if (avatars.Length > 0)
            _selected = avatars[_list.SelectedIndex = Math.Max(_list.SelectedIndex, 0)].AvatarIndex;
        _rates.Text = $"{avatars.Sum(static avatar => avatar.FrameRate):0} frames/s received, {_shown * 1000 / _timer.Interval} frames/s shown";
        _shown = 0;
    }
}
