#nullable enable

using System;
using System.Net;
using System.Threading.Tasks;
using NeuronMocap.Recording;
using NeuronMocap.Server;

namespace NeuronMocap.Unity
{
    // The state that sources with equal settings share: a reader and, for kinds other than the network, what it receives from. Opening and closing
    // return at once. Pool threads read files and wait for threads.
    internal sealed class SourceConnection
    {
        private readonly object _gate = new object();
        private readonly Task _opening;
        private readonly GameClock? _game;
        private NeuronReader? _reader;
        private Broadcaster? _broadcaster;
        private RecordingPlayer? _player;
        private string? _fault;
        private bool _isClosed;

        // Main thread. after: a task that must end before the connection opens, such as the closing of another one's socket.
        public SourceConnection(SourceSettings settings, Task after)
        {
            Settings = settings;
            _game = settings.IsFile ? new GameClock() : null;

            // Only the main thread may use Unity's objects.
            byte[]? bytes = settings.Asset != null ? settings.Asset.bytes : null;
            _opening = settings.Kind is SourceKind.Network or SourceKind.Simulator ? OpenAsync(bytes: null, after) : Task.Run(() => OpenAsync(bytes, after));
        }

        public SourceSettings Settings { get; }

        public AvatarStreams Streams { get; } = new AvatarStreams();

        // The number of sources that use it. Main thread.
        public int UserCount { get; set; }

        public NeuronReader? Reader
        {
            get
            {
                lock (_gate)
                    return _reader;
            }
        }

        // Only for recordings: the player of a BVH file may never end.
        public RecordingPlayer? Player
        {
            get
            {
                lock (_gate)
                    return Settings.Kind == SourceKind.Recording ? _player : null;
            }
        }

        // Why there is and will be no reader. Null if there is no problem.
        public string? Fault
        {
            get
            {
                lock (_gate)
                    return _fault;
            }
        }

        // Main thread, in each Update. Returns the time of this rendered frame, on the clock that stamps the frames of the stream.
        public long Advance()
        {
            if (_game is null)
                return SourceClock.Now;

            RecordingPlayer? player;
            lock (_gate)
                player = _player;

            return _game.Advance(player);
        }

        // Closes sockets and files at once, without waiting. The task ends when all threads have ended.
        public Task Close()
        {
            lock (_gate)
                _isClosed = true;

            return Task.WhenAll(_opening, StopAsync());
        }

        // After closing, only the opening thread still sets fields, and it stops what it has set. Runs outside the lock, because handlers may run meanwhile.
        private Task StopAsync()
        {
            _player?.Dispose();
            return Task.WhenAll(
                _reader?.DisposeAsync().AsTask() ?? Task.CompletedTask,
                _broadcaster?.DisposeAsync().AsTask() ?? Task.CompletedTask);
        }

        private async Task OpenAsync(byte[]? bytes, Task after)
        {
            try
            {
                // Whether it succeeded or failed.
                await Task.WhenAny(after).ConfigureAwait(false);
                (Broadcaster? broadcaster, RecordingPlayer? player) = CreateFeed(bytes);
                if (!TryReceive(broadcaster, player))
                    await StopAsync().ConfigureAwait(false);
            }
            catch (Exception exception)
            {
                // Catches everything: no caller awaits this task, and the source would show Loading forever.
                lock (_gate)
                    _fault = StatusText.OfFault(Settings, exception);
            }
        }

        private (Broadcaster? Broadcaster, RecordingPlayer? Player) CreateFeed(byte[]? bytes) => Settings.Kind switch
        {
            SourceKind.Simulator => (SourceFeeds.CreateSimulator(Settings), null),
            SourceKind.BvhFile => (null, SourceFeeds.OpenTake(Settings, bytes, _game!.Clock)),
            SourceKind.Recording => (null, SourceFeeds.OpenRecording(Settings, _game!.Clock)),
            _ => (null, null),
        };

        // False if the source closed while it waited or a file was read. Nothing would stop what starts now.
        private bool TryReceive(Broadcaster? broadcaster, RecordingPlayer? player)
        {
            lock (_gate)
            {
                _broadcaster = broadcaster;
                _player = player;
                if (_isClosed)
                    return false;

                NeuronReaderOptions options = CreateOptions(broadcaster);
                _reader = player != null ? new NeuronReader(player, options) : new NeuronReader(options);
                _reader.MotionReceived += Streams.OnMotion;
                _reader.CalculationReceived += Streams.OnCalculation;
                Streams.Reader = _reader;
                _reader.Start();
                return true;
            }
        }

        private static IPAddress? ParseLocalAddress(string text)
        {
            if (text.Length == 0)
                return null;

            return IPAddress.TryParse(text, out IPAddress? address)
                ? address
                : throw new ArgumentException($"LocalAddress is '{text}'. It must be an IP address of this computer, or empty.", nameof(text));
        }

        private NeuronReaderOptions CreateOptions(Broadcaster? broadcaster)
        {
            var options = new NeuronReaderOptions
            {
                RotationOrder = Settings.RotationOrder,
                SkeletonVariant = Settings.Variant,
                Reconnect = new ReconnectPolicy { Enabled = Settings.Reconnect },
            };
            if (broadcaster != null)
            {
                options.Source = broadcaster.CreateLocalSource(Settings.Target);
            }
            else if (Settings.Kind == SourceKind.Network)
            {
                options.Host = Settings.Address;
                options.Port = Settings.Port;
                options.CalculationPort = Settings.CalculationPort;
                options.Transport = Settings.Transport;
                options.LocalAddress = ParseLocalAddress(Settings.LocalAddress);
                options.CommandPort = Settings.CommandPort;
            }

            return options;
        }
    }
}
