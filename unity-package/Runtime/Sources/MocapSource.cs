#nullable enable

using System;
using NeuronMocap.Motion;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Brings motion into the scene: from Axis Neuron or Axis Studio on the network, from the built-in simulator, a BVH file or a recording. One is enough for
    /// any number of figures; sources with equal settings share one connection. It opens when it is enabled, closes when it is disabled, and opens
    /// anew by itself when a setting is changed while it runs.
    /// <para>
    /// All members are for the main thread. What arrives is taken over once per rendered frame, in Update, before other scripts run.
    /// </para>
    /// </summary>
    [AddComponentMenu("NeuronMocap/Mocap Source")]
    [DefaultExecutionOrder(-100)]
    [DisallowMultipleComponent]
    public sealed partial class MocapSource : MonoBehaviour
    {
        [Tooltip("Where the motion comes from: the network, simulated performers, a BVH file, or a recording.")]
        [SerializeField]
        private SourceKind _kind;

        [Header("Network")]
        [Tooltip("Name or address of the computer that runs Axis Neuron or Axis Studio. 127.0.0.1 is this computer. Not used for UDP.")]
        [Delayed]
        [SerializeField]
        private string _address = "127.0.0.1";

        [Tooltip("TCP port of the server, or UDP port to receive on, as in the broadcasting settings of Axis Neuron. Usually 7001.")]
        [Delayed]
        [SerializeField]
        private int _port = 7001;

        [Tooltip("Port of the server's calculation data, which has measured foot contacts; usually 7003. 0: they come over Port, or not at all.")]
        [Delayed]
        [SerializeField]
        private int _calculationPort;

        [Tooltip("TCP or UDP, as set on the server.")]
        [SerializeField]
        private TransportKind _transport;

        [Tooltip("Address of this computer to connect from, or to receive UDP on; for a computer with several networks. Empty: the system chooses for TCP, and "
            + "UDP is received on all IPv4 addresses.")]
        [Delayed]
        [SerializeField]
        private string _localAddress = string.Empty;

        [Tooltip("Connect again after a connection failed or ended.")]
        [SerializeField]
        private bool _reconnect = true;

        [Tooltip("TCP port of the server's command channel, usually 8013; 0 for none. With one, the rotation order, the skeleton variant and the performers' "
            + "sizes are asked for.")]
        [Delayed]
        [SerializeField]
        private int _commandPort;

        [Header("Format")]
        [Tooltip("Order of the rotation values, a setting of the server. Auto: what the stream or the command channel says, else YXZ, Axis Neuron's default.")]
        [SerializeField]
        private RotationOrderSetting _rotationOrder;

        [Tooltip("How spine and neck are divided. Auto: what the command channel says, else Neck1, which is right for everything since 2018.")]
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

        [Tooltip("A BVH file as a text asset (give it the ending .txt or .bytes); takes precedence over File. Use it where StreamingAssets are not files, such as on Android.")]
        [SerializeField]
        private TextAsset? _bvhAsset;

        [Tooltip("Start again at the end.")]
        [SerializeField]
        private bool _loop = true;

        [Tooltip("Playback speed; 1 is the recorded speed. A change restarts the file.")]
        [Range(0.1f, 10)]
        [SerializeField]
        private float _speed = 1;

        [Header("Timing")]
        [Tooltip("Resample the motion at the time of each rendered frame, with a short delay, so that network jitter does not show. Off: use the newest frame.")]
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

        [Header("Scenes")]
        [Tooltip("Keep the source, and its connection, when another scene is loaded. It must be on its own object at the root of the scene.")]
        [SerializeField]
        private bool _persistAcrossScenes;

        /// <summary>Where the motion comes from.</summary>
        public SourceKind Kind
        {
            get => _kind;
            set => Set(ref _kind, value);
        }

        /// <summary>Name or address of the server; not used for UDP. 127.0.0.1 unless set.</summary>
        public string Address
        {
            get => _address;
            set => Set(ref _address, value ?? string.Empty);
        }

        /// <summary>TCP port of the server, or UDP port to receive on, 1 to 65535. 7001 unless set.</summary>
        public int Port
        {
            get => _port;
            set => Set(ref _port, value);
        }

        /// <summary>
        /// Port of the server's calculation data, over the same transport as <see cref="Port"/>, 1 to 65535; 0, the default, for none. Usually 7003. They carry
        /// the foot contacts that the server measured.
        /// </summary>
        public int CalculationPort
        {
            get => _calculationPort;
            set => Set(ref _calculationPort, value);
        }

        /// <summary>TCP or UDP. TCP unless set.</summary>
        public TransportKind Transport
        {
            get => _transport;
            set => Set(ref _transport, value);
        }

        /// <summary>Address of this computer to connect from, or to receive UDP on; empty, the default, for the system's choice, and for UDP all IPv4 addresses.</summary>
        public string LocalAddress
        {
            get => _localAddress;
            set => Set(ref _localAddress, value ?? string.Empty);
        }

        /// <summary>Whether a connection that failed or ended is tried again. True unless set.</summary>
        public bool Reconnect
        {
            get => _reconnect;
            set => Set(ref _reconnect, value);
        }

        /// <summary>TCP port of the server's command channel, 1 to 65535; 0, the default, for none.</summary>
        public int CommandPort
        {
            get => _commandPort;
            set => Set(ref _commandPort, value);
        }

        /// <summary>Order of the rotation values. Auto unless set.</summary>
        public RotationOrderSetting RotationOrder
        {
            get => _rotationOrder;
            set => Set(ref _rotationOrder, value);
        }

        /// <summary>How spine and neck are divided. Auto unless set.</summary>
        public SkeletonVariantSetting SkeletonVariant
        {
            get => _skeletonVariant;
            set => Set(ref _skeletonVariant, value);
        }

        /// <summary>How many performers the simulator has, 1 to 32. 1 unless set.</summary>
        public int PerformerCount
        {
            get => _performerCount;
            set => Set(ref _performerCount, value);
        }

        /// <summary>What the performers of the simulator do.</summary>
        public SimulatedMotion Motion
        {
            get => _motion;
            set => Set(ref _motion, value);
        }

        /// <summary>Frames per second that the simulator sends, 10 to 240. 60 unless set.</summary>
        public float SimulatedFrameRate
        {
            get => _simulatedFrameRate;
            set => Set(ref _simulatedFrameRate, value);
        }

        /// <summary>A BVH file, a recording or a raw dump: an absolute path, or one relative to <c>Application.streamingAssetsPath</c>.</summary>
        public string File
        {
            get => _file;
            set => Set(ref _file, value ?? string.Empty);
        }

        /// <summary>A BVH file as a text asset; goes before <see cref="File"/>.</summary>
        public TextAsset? BvhAsset
        {
            get => _bvhAsset;
            set => Set(ref _bvhAsset, value);
        }

        /// <summary>Whether a file begins again at its end. True unless set.</summary>
        public bool Loop
        {
            get => _loop;
            set => Set(ref _loop, value);
        }

        /// <summary>How many times as fast as it was recorded a file is played, 0.1 to 10. 1 unless set. A change begins the file again; <see cref="Player"/> changes the speed of a recording as it runs.</summary>
        public float Speed
        {
            get => _speed;
            set => Set(ref _speed, value);
        }

        /// <summary>Whether the motion is shown at the moments of the rendered frames, <see cref="Delay"/> behind; else the newest frame as it is. True unless set.</summary>
        public bool Resample
        {
            get => _resample;
            set => _resample = value;
        }

        /// <summary>How far behind the motion is shown, 0 to 500 ms. 30 unless set. Changes without a new connection.</summary>
        public float Delay
        {
            get => _delay;
            set => _delay = value;
        }

        /// <summary>How poses between two frames are made. Cubic unless set.</summary>
        public PoseInterpolationMethod Interpolation
        {
            get => _interpolation;
            set => _interpolation = value;
        }

        /// <summary>After how many seconds without a frame a performer is idle (<see cref="Performer.IsLive"/>), 0.1 to 60. 1 unless set.</summary>
        public float IdleTimeout
        {
            get => _idleTimeout;
            set => _idleTimeout = value;
        }

        /// <summary>After how many seconds without a frame a performer is gone (<see cref="PerformerLeft"/>); 0 for never. 10 unless set.</summary>
        public float LeaveTimeout
        {
            get => _leaveTimeout;
            set => _leaveTimeout = value;
        }

        /// <summary>Whether the source lives on when another scene is loaded. It counts when the object wakes up.</summary>
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
