#nullable enable

using System;
using NeuronMocap.Motion;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Brings motion into the scene from Axis Neuron or Axis Studio on the network, the built-in simulator, a BVH file or a recording. One
    /// source is enough for any number of figures. Sources with equal settings share one connection. The source is open while it is
    /// enabled, and reopens automatically when a setting changes at run time.
    /// <para>
    /// All members are for the main thread. The source takes over received data once per rendered frame, in Update, before other scripts run.
    /// </para>
    /// </summary>
    [AddComponentMenu("NeuronMocap/Mocap Source")]
    [HelpURL(HelpPage.Components + "#mocap-source")]
    [DefaultExecutionOrder(-100)]
    [DisallowMultipleComponent]
    public sealed partial class MocapSource : MonoBehaviour
    {
        [Tooltip("Where the motion comes from: the network, simulated performers, a BVH file, or a recording.")]
        [SerializeField]
        private SourceKind _kind;

        [Header("Network")]
        [Tooltip("Name or address of the computer that runs Axis Neuron or Axis Studio. 127.0.0.1 is this computer. Over UDP, used only for the command channel.")]
        [Delayed]
        [SerializeField]
        private string _address = "127.0.0.1";

        [Tooltip("TCP port of the server, or UDP port to receive on, as in the broadcasting settings of Axis Neuron. Usually 7001.")]
        [Delayed]
        [SerializeField]
        private int _port = 7001;

        [Tooltip("Port of the server's calculation data, which has measured foot contacts; usually 7003. 0: on the same port, or not sent.")]
        [Delayed]
        [SerializeField]
        private int _calculationPort;

        [Tooltip("TCP or UDP, as set on the server.")]
        [SerializeField]
        private TransportKind _transport;

        [Tooltip("Address of this computer to connect from, or to receive UDP on. Set it on a computer with several networks. Empty: the system chooses for TCP, and "
            + "UDP is received on all IPv4 addresses.")]
        [Delayed]
        [SerializeField]
        private string _localAddress = string.Empty;

        [Tooltip("Connect again after a connection fails or ends.")]
        [SerializeField]
        private bool _reconnect = true;

        [Tooltip("TCP port of the server's command channel, usually 8013; 0 for none. The source asks it for the rotation order, the skeleton variant and the performers' "
            + "sizes.")]
        [Delayed]
        [SerializeField]
        private int _commandPort;

        [Header("Format")]
        [Tooltip("Order of the rotation values, a setting of the server. Auto: from the stream or the command channel, or else YXZ, Axis Neuron's default.")]
        [SerializeField]
        private RotationOrderSetting _rotationOrder;

        [Tooltip("Division of spine and neck. Auto: from the command channel, or else Neck1, which all servers use since 2018.")]
        [SerializeField]
        private SkeletonVariantSetting _skeletonVariant;

        [Header("Simulator")]
        [Tooltip("How many performers the simulator has.")]
        [Range(1, 32)]
        [SerializeField]
        private int _performerCount = 1;

        [Tooltip("What the simulated performers do.")]
        [SerializeField]
        private SimulatedMotion _motion;

        [Tooltip("Frames per second that the simulator sends.")]
        [Range(10, 240)]
        [SerializeField]
        private float _simulatedFrameRate = 60;

        [Header("File")]
        [Tooltip("A BVH file, a recording (.nmrec) or a raw dump: an absolute path, or one relative to the StreamingAssets folder.")]
        [Delayed]
        [SerializeField]
        private string _file = string.Empty;

        [Tooltip("A BVH file as a text asset, with the extension .txt or .bytes. It takes precedence over File. Use it where StreamingAssets are not files, such as on Android.")]
        [SerializeField]
        private TextAsset? _bvhAsset;

        [Tooltip("Start again at the end.")]
        [SerializeField]
        private bool _loop = true;

        [Tooltip("Playback speed; 1 is the recorded speed. Files follow the time of the game, so they stop and slow down with it. A change restarts the file.")]
        [Range(0.1f, 10)]
        [SerializeField]
        private float _speed = 1;

        [Header("Timing")]
        [Tooltip("Resample the motion at the time of each rendered frame, with a short delay, to hide network jitter. Off: use the newest frame.")]
        [SerializeField]
        private bool _resample = true;

        [Tooltip("Delay of the motion, in milliseconds. One frame of the stream plus its jitter is enough: 30 on a cable, 60 on Wi-Fi.")]
        [Range(0, 500)]
        [SerializeField]
        private float _delay = 30;

        [Tooltip("How to interpolate between two frames of the stream. Cubic keeps the speed steady.")]
        [SerializeField]
        private PoseInterpolationMethod _interpolation = PoseInterpolationMethod.Cubic;

        [Tooltip("A performer becomes idle after this many seconds without a frame.")]
        [Range(0.1f, 60)]
        [SerializeField]
        private float _idleTimeout = 1;

        [Tooltip("A performer is removed after this many seconds without a frame. 0: never.")]
        [Range(0, 600)]
        [SerializeField]
        private float _leaveTimeout = 10;

        [Header("Stage")]
        [Tooltip("Where the performers of this source stand in the scene. Set it here, not at single figures: figures, spawners, views and scripts all use it.")]
        [SerializeField]
        private SourceStage _stage = new SourceStage();

        [Tooltip("Key that makes the place and the facing of the first performer origin and forward of the stage. It works with the old Input Manager "
            + "and with the Input System.")]
        [SerializeField]
        private KeyCode _recenterKey;

        [Header("Scenes")]
        [Tooltip("Keep the source, and its connection, when another scene is loaded. It must be on its own object at the root of the scene.")]
        [SerializeField]
        private bool _persistAcrossScenes;

        /// <summary>Gets or sets where the motion comes from.</summary>
        public SourceKind Kind
        {
            get => _kind;
            set => Set(ref _kind, value);
        }

        /// <summary>Gets or sets the name or address of the server. Over UDP, it is used only for the command channel. The default is 127.0.0.1.</summary>
        public string Address
        {
            get => _address;
            set => Set(ref _address, value ?? string.Empty);
        }

        /// <summary>Gets or sets the TCP port of the server, or the UDP port to receive on, 1 to 65535. The default is 7001.</summary>
        public int Port
        {
            get => _port;
            set => Set(ref _port, value);
        }

        /// <summary>
        /// Gets or sets the port of the server's calculation data, over the same transport as <see cref="Port"/>, 1 to 65535. The default is 0, for
        /// none. The usual port is 7003. Calculation data carries the foot contacts measured by the server.
        /// </summary>
        public int CalculationPort
        {
            get => _calculationPort;
            set => Set(ref _calculationPort, value);
        }

        /// <summary>Gets or sets the transport. The default is TCP.</summary>
        public TransportKind Transport
        {
            get => _transport;
            set => Set(ref _transport, value);
        }

        /// <summary>
        /// Gets or sets the address of this computer to connect from, or to receive UDP on. Empty, the default: the system chooses, and UDP is
        /// received on all IPv4 addresses.
        /// </summary>
        public string LocalAddress
        {
            get => _localAddress;
            set => Set(ref _localAddress, value ?? string.Empty);
        }

        /// <summary>Gets or sets whether the source reconnects after a connection fails or ends. The default is true.</summary>
        public bool Reconnect
        {
            get => _reconnect;
            set => Set(ref _reconnect, value);
        }

        /// <summary>Gets or sets the TCP port of the server's command channel, 1 to 65535. The default is 0, for none.</summary>
        public int CommandPort
        {
            get => _commandPort;
            set => Set(ref _commandPort, value);
        }

        /// <summary>Gets or sets the order of the rotation values. The default is Auto.</summary>
        public RotationOrderSetting RotationOrder
        {
            get => _rotationOrder;
            set => Set(ref _rotationOrder, value);
        }

        /// <summary>Gets or sets the division of spine and neck. The default is Auto.</summary>
        public SkeletonVariantSetting SkeletonVariant
        {
            get => _skeletonVariant;
            set => Set(ref _skeletonVariant, value);
        }

        /// <summary>Gets or sets the number of performers in the simulator, 1 to 32. The default is 1.</summary>
        public int PerformerCount
        {
            get => _performerCount;
            set => Set(ref _performerCount, value);
        }

        /// <summary>Gets or sets what the performers of the simulator do.</summary>
        public SimulatedMotion Motion
        {
            get => _motion;
            set => Set(ref _motion, value);
        }

        /// <summary>Gets or sets the frame rate of the simulator, 10 to 240. The default is 60.</summary>
        public float SimulatedFrameRate
        {
            get => _simulatedFrameRate;
            set => Set(ref _simulatedFrameRate, value);
        }

        /// <summary>
        /// Gets or sets the path of a BVH file, a recording or a raw dump. The path is absolute, or relative to
        /// <c>Application.streamingAssetsPath</c>.
        /// </summary>
        public string File
        {
            get => _file;
            set => Set(ref _file, value ?? string.Empty);
        }

        /// <summary>Gets or sets a BVH file as a text asset. It takes precedence over <see cref="File"/>.</summary>
        public TextAsset? BvhAsset
        {
            get => _bvhAsset;
            set => Set(ref _bvhAsset, value);
        }

        /// <summary>Gets or sets whether a file starts again at its end. The default is true.</summary>
        public bool Loop
        {
            get => _loop;
            set => Set(ref _loop, value);
        }

        /// <summary>
        /// Gets or sets the playback speed of a file, 0.1 to 10. 1, the default, is the recorded speed. A change restarts the file.
        /// <see cref="Player"/> changes the speed of a recording without a restart.
        /// </summary>
        public float Speed
        {
            get => _speed;
            set => Set(ref _speed, value);
        }

        /// <summary>
        /// Gets or sets whether the motion is resampled at the times of the rendered frames, <see cref="Delay"/> behind. If false, the newest frame
        /// is shown. The default is true.
        /// </summary>
        public bool Resample
        {
            get => _resample;
            set => _resample = value;
        }

        /// <summary>Gets or sets the delay of the motion, 0 to 500 ms. The default is 30. A change needs no new connection.</summary>
        public float Delay
        {
            get => _delay;
            set => _delay = value;
        }

        /// <summary>Gets or sets the interpolation between two frames. The default is Cubic.</summary>
        public PoseInterpolationMethod Interpolation
        {
            get => _interpolation;
            set => _interpolation = value;
        }

        /// <summary>
        /// Gets or sets after how many seconds without a frame a performer is idle (<see cref="Performer.IsLive"/>), 0.1 to 60. The default is 1.
        /// </summary>
        public float IdleTimeout
        {
            get => _idleTimeout;
            set => _idleTimeout = value;
        }

        /// <summary>
        /// Gets or sets after how many seconds without a frame a performer is removed (<see cref="PerformerLeft"/>). 0 for never. The default is 10.
        /// </summary>
        public float LeaveTimeout
        {
            get => _leaveTimeout;
            set => _leaveTimeout = value;
        }

        /// <summary>Gets or sets whether the source stays when another scene is loaded. The value is read when the object wakes up.</summary>
        public bool PersistAcrossScenes
        {
            get => _persistAcrossScenes;
            set => _persistAcrossScenes = value;
        }

        private void Set<T>(ref T field, T value)
        {
            field = value;
            _isChanged = true;
        }
    }
}
