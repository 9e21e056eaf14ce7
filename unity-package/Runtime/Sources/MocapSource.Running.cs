#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Recording;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Opening, closing and the work of each rendered frame. Fields are [NonSerialized] because the editor keeps private fields when it compiles
    // scripts in play mode, but the objects that they refer to are gone.
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

        /// <summary>Gets the enabled sources, in the order in which they were enabled. A figure without its own source takes the first.</summary>
        public static IReadOnlyList<MocapSource> All => Enabled;

        /// <summary>Occurs in Update when <see cref="State"/> has changed, and when the source closes.</summary>
        public event Action<SourceState>? StateChanged;

        /// <summary>Gets what the source is doing.</summary>
        public SourceState State { get; private set; }

        /// <summary>Gets what the source is doing, in one or two sentences. If a setting can help, they name it as the inspector does.</summary>
        public string StatusMessage { get; private set; } = StatusText.Closed;

        /// <summary>Gets the library's reason for the state of the connection.</summary>
        public ConnectionReason Reason => _status.Reason;

        /// <summary>Gets whether the source is open, even if nothing arrives.</summary>
        public bool IsOpen => _connection != null;

        /// <summary>
        /// Gets the reader behind the source, for features that the component does not offer: statistics, recording, commands. Other sources with
        /// equal settings share it, so do not dispose it. Null while the source is closed, while a file is read, and while a UDP source waits
        /// for a port that was just closed.
        /// </summary>
        public NeuronReader? Reader => _connection?.Reader;

        /// <summary>Gets the player of the recording, to pause, step or seek. Null for other kinds, and while the file is being opened.</summary>
        public RecordingPlayer? Player => _connection?.Player;

        /// <summary>Gets the number of lost frames since the source was opened: frames that the server sent but that did not arrive.</summary>
        public long LostFrames => Reader?.GetStatistics().Lost ?? 0;

        internal static void ForgetAll() => Enabled.Clear();

        /// <summary>
        /// Opens the source and returns at once. If the source is already open, this does nothing. The source opens automatically in the first frame
        /// after the component is enabled, before the Start of other scripts. A script that adds the component can thus configure it first.
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

        /// <summary>
        /// Closes the source and returns at once. The source closes automatically when the component is disabled. Further calls do nothing.
        /// </summary>
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

            // Unless a handler reopened it.
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

        // A field was changed in the inspector. Ports have no slider: a typed value applies when it is entered.
        private void OnValidate()
        {
            _port = Mathf.Clamp(_port, 1, 65535);
            _calculationPort = Mathf.Clamp(_calculationPort, 0, 65535);
            _commandPort = Mathf.Clamp(_commandPort, 0, 65535);
            _isChanged = true;
        }

        private void Update()
        {
            // Enabled again, or kept by the editor across a script compilation.
            if (_isDue)
                Open();

            FollowRecenterKey();
            Follow();
        }

        private void Follow()
        {
            if (_isChanged && _connection != null)
                Reopen();
            if (!(_connection is { } connection))
                return;

            // A handler may close and reopen the source at any of these points.
            TakeStatus(connection);
            if (_connection == connection)
                TakePerformers(connection);
        }

        // A scene that is loaded again creates the source again. Only one of the two stays.
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
                if (connection.Fault is { } fault)
                    Report(SourceState.Failed, fault);
                else
                    Report(connection.Settings.IsFile ? SourceState.Loading : SourceState.Connecting, StatusText.OfOpening(connection.Settings));

                return;
            }

            ConnectionStatus status = reader.Status;
            if (status.Timestamp == _status.Timestamp && status.State == _status.State && ReferenceEquals(status.Message, _status.Message))
                return;

            _status = status;
            Report(ToState(status), StatusText.Of(connection, status));
        }

        private static SourceState ToState(in ConnectionStatus status) => status.State switch
        {
            ConnectionState.Connected => SourceState.Connected,
            ConnectionState.Receiving => SourceState.Receiving,
            ConnectionState.Silent => SourceState.Silent,
            ConnectionState.Waiting => SourceState.Waiting,
            ConnectionState.Stopped when status.Reason == ConnectionReason.EndOfRecording => SourceState.Ended,
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

                // A BVH file defines its own order; raw bytes do not.
                RotationOrder = isBvh ? null : _rotationOrder.ToOrder(),
                Variant = isBvh ? null : _skeletonVariant.ToVariant(),
            };
        }
    }
}
