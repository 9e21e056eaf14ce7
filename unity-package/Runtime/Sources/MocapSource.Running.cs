#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Recording;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Opening, closing and the work of each rendered frame. [NonSerialized]: when the editor compiles scripts in play mode it carries private fields over,
    // and what they refer to is gone.
    public sealed partial class MocapSource
    {
        private static readonly List<MocapSource> Enabled = new List<MocapSource>();

        [NonSerialized]
        private SourceConnection? _connection;

        [NonSerialized]
        private ConnectionStatus _status;

        [NonSerialized]
        private bool _isDue;

        [NonSerialized]
        private bool _isChanged;

        [NonSerialized]
        private SourceState _reported;

        /// <summary>The sources that are enabled now, in the order in which they were; a figure without a source of its own takes the first.</summary>
        public static IReadOnlyList<MocapSource> All => Enabled;

        /// <summary>Raised in Update when <see cref="State"/> has become another, and when the source closes.</summary>
        public event Action<SourceState>? StateChanged;

        /// <summary>What the source is doing.</summary>
        public SourceState State { get; private set; }

        /// <summary>What the source is doing, in one or two sentences; where a setting can help, they name it as the inspector does.</summary>
        public string StatusMessage { get; private set; } = StatusText.Closed;

        /// <summary>Why the connection is in its state, as the library has it.</summary>
        public ConnectionReason Reason => _status.Reason;

        /// <summary>Whether the source is open, whatever arrives.</summary>
        public bool IsOpen => _connection != null;

        /// <summary>
        /// The reader behind the source, for what the component does not offer: statistics, recording, commands. Shared with other sources of equal settings:
        /// do not dispose of it. Null while the source is closed, and while a file is read.
        /// </summary>
        public NeuronReader? Reader => _connection?.Reader;

        /// <summary>What plays the recording, to pause, step or seek; null for other kinds, and while the file is opened.</summary>
        public RecordingPlayer? Player => _connection?.Player;

        /// <summary>Frames that the server sent and that did not arrive, since the source was opened.</summary>
        public long LostFrames => Reader?.GetStatistics().Lost ?? 0;

        internal static void ForgetAll() => Enabled.Clear();

        /// <summary>
        /// Opens the source; returns at once. Done in the first frame after the component was enabled, before the Start of other scripts, so that a script that
        /// adds the component can set it first. Opening again does nothing.
        /// </summary>
        public void Open()
        {
            _isDue = false;
            if (_connection != null)
                return;

            _isChanged = false;
            _status = default;
            if (Application.platform == RuntimePlatform.WebGLPlayer)
            {
                Report(SourceState.Failed, StatusText.Browser);
                return;
            }

            _connection = SourceConnections.Acquire(CreateSettings());
            TakeStatus(_connection);
        }

        /// <summary>Closes the source; returns at once. Done when the component is disabled. Closing again does nothing.</summary>
        public void Close()
        {
            _isDue = false;
            if (_connection is { } connection)
            {
                _connection = null;
                SourceConnections.Release(connection);
            }

            _status = default;
            while (_performers.Count > 0)
                Remove(_performers.Count - 1);

            // Unless a handler has opened it again.
            if (_connection is null)
                Report(SourceState.Closed, StatusText.Closed);
        }

        private void Awake()
        {
            if (_persistAcrossScenes && !IsKeptAlready())
                DontDestroyOnLoad(gameObject);
        }

        private void OnEnable()
        {
            Enabled.Add(this);
            _isDue = true;
        }

        private void Start()
        {
            if (_isDue)
                Open();
        }

        private void OnDisable()
        {
            Enabled.Remove(this);
            Close();
        }

        // A field was changed in the inspector. Ports have no slider: they are typed, and count when they are entered.
        private void OnValidate()
        {
            _port = Mathf.Clamp(_port, 1, 65535);
            _calculationPort = Mathf.Clamp(_calculationPort, 0, 65535);
            _commandPort = Mathf.Clamp(_commandPort, 0, 65535);
            _isChanged = true;
        }

        private void Update()
        {
            // Enabled again, or carried over by the editor into new scripts.
            if (_isDue)
                Open();
            if (_isChanged && _connection != null)
                Reopen();
            if (!(_connection is { } connection))
                return;

            // A handler may close the source at any of these points, and open it again.
            TakeStatus(connection);
            if (_connection == connection)
                TakePerformers(connection);
        }

        // A scene that is loaded again brings the source again: one of the two is enough.
        private bool IsKeptAlready()
        {
            SourceSettings settings = CreateSettings();
            for (int i = 0; i < Enabled.Count; i++)
            {
                if (Enabled[i] != this && Enabled[i]._persistAcrossScenes && Enabled[i].CreateSettings() == settings)
                    return true;
            }

            return false;
        }

        private void Reopen()
        {
            _isChanged = false;
            if (CreateSettings() == _connection!.Settings)
                return;

            Close();
            Open();
        }

        private void TakeStatus(SourceConnection connection)
        {
            if (connection.Reader is not { } reader)
            {
                Report(connection.Fault is null ? SourceState.Loading : SourceState.Failed, connection.Fault ?? StatusText.Loading);
                return;
            }

            ConnectionStatus status = reader.Status;
            if (status.Timestamp == _status.Timestamp && status.State == _status.State && ReferenceEquals(status.Message, _status.Message))
                return;

            _status = status;
            Report(ToState(connection, status), StatusText.Of(connection, status));
        }

        private static SourceState ToState(SourceConnection connection, in ConnectionStatus status) => status.State switch
        {
            ConnectionState.Connected => SourceState.Connected,
            ConnectionState.Receiving => SourceState.Receiving,
            ConnectionState.Silent => SourceState.Silent,
            ConnectionState.Waiting => SourceState.Waiting,
            ConnectionState.Stopped when status.Reason == ConnectionReason.EndOfRecording => SourceState.Ended,
            ConnectionState.Stopped when status.Reason == ConnectionReason.ClosedByPeer && connection.Settings.Kind == SourceKind.BvhFile => SourceState.Ended,
            ConnectionState.Stopped when status.Reason == ConnectionReason.Requested => SourceState.Closed,
            ConnectionState.Stopped => SourceState.Failed,
            _ => SourceState.Connecting,
        };

        private void Report(SourceState state, string message)
        {
            State = state;
            StatusMessage = message;
            if (_reported == state)
                return;

            _reported = state;
            Handlers.Raise(StateChanged, state, this);
        }

        private SourceSettings CreateSettings()
        {
            switch (_kind)
            {
                case SourceKind.Simulator:
                    return new SourceSettings { Kind = _kind, Performers = _performerCount, Motion = _motion, FrameRate = _simulatedFrameRate, Reconnect = true };
                case SourceKind.BvhFile:
                case SourceKind.Recording:
                    return CreateFileSettings();
                default:
                    return new SourceSettings
                    {
                        Kind = _kind,
                        Address = _transport == TransportKind.Tcp || _commandPort > 0 ? _address.Trim() : "127.0.0.1",
                        Port = _port,
                        CalculationPort = _calculationPort != 0 ? _calculationPort : (int?)null,
                        Transport = _transport,
                        LocalAddress = _localAddress.Trim(),
                        Reconnect = _reconnect,
                        CommandPort = _commandPort > 0 ? _commandPort : (int?)null,
                        RotationOrder = _rotationOrder.ToOrder(),
                        Variant = _skeletonVariant.ToVariant(),
                    };
            }
        }

        private SourceSettings CreateFileSettings()
        {
            bool isBvh = _kind == SourceKind.BvhFile;
            TextAsset? asset = isBvh && _bvhAsset != null ? _bvhAsset : null;
            string file = asset is null ? SourceFiles.Resolve(_file) : string.Empty;
            return new SourceSettings
            {
                Kind = _kind,
                File = file,
                Asset = asset,
                Name = asset is null ? SourceFiles.NameOf(file) : asset.name,
                Loop = _loop,
                Speed = _speed,

                // A file says itself what is in it; raw bytes do not.
                RotationOrder = isBvh ? null : _rotationOrder.ToOrder(),
                Variant = isBvh ? null : _skeletonVariant.ToVariant(),
                Reconnect = isBvh && _loop,
            };
        }
    }
}
