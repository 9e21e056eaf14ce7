#nullable enable
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Records what a <see cref="MocapSource"/> receives at run time, in the editor and in players. It writes BVH files, or recordings that play
    /// again like the live stream. Other threads write, and the main thread never waits for the disk. A take ends with <see cref="StopRecording"/>,
    /// with the component or the source, and when the application quits. If the process is killed, the files can still be opened.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Motion Recorder")]
    [HelpURL(HelpPage.Components + "#motion-recorder")]
    public sealed class MotionRecorder : TakeRecorder
    {
        // Files are usually complete much earlier, unless the disk is very slow. An incomplete file can still be opened.
        private static readonly TimeSpan LongestWaitAtQuit = TimeSpan.FromMilliseconds(100);

        [SerializeField]
        [Tooltip("The source whose motion is recorded.")]
        private MocapSource? _source;

        [SerializeField]
        [Tooltip("BVH opens in animation programs. A recording keeps every byte with its time and plays again like the live stream.")]
        private TakeFormats _formats = TakeFormats.Bvh;

        [SerializeField]
        [Tooltip("Folder of the files. Empty: the application's data folder. A relative path starts there.")]
        private string _folder = "";

        [SerializeField]
        [Tooltip("Write a BVH file for each performer. Off: for one performer only.")]
        private bool _allPerformers = true;

        [SerializeField]
        [Min(0)]
        [Tooltip("Number on the server of the performer to export to BVH, unless all are exported.")]
        private int _performerIndex;

        private readonly Stopwatch _elapsed = new Stopwatch();
        private TakeWriter? _take;
        private bool _isWaiting;

        /// <summary>
        /// Occurs when a take's files are complete. The argument holds their full paths. Raised in Update, on the main thread.
        /// </summary>
        /// <remarks>
        /// If a take ends because the component is disabled, the event occurs when the component is enabled again. If a take ends with its object or
        /// the application, the event does not occur. The files are completed in each case.
        /// </remarks>
        public event Action<IReadOnlyList<string>>? Finished;

        /// <summary>Gets or sets the source whose motion is recorded.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Gets or sets what the next take writes.</summary>
        public TakeFormats Formats
        {
            get => _formats;
            set => _formats = value;
        }

        /// <summary>
        /// Gets or sets the folder of the next take's files. Empty: <see cref="Application.persistentDataPath"/>, where relative paths also start.
        /// The folder is created.
        /// </summary>
        public string Folder
        {
            get => _folder;
            set => _folder = value ?? "";
        }

        /// <summary>Gets or sets whether every performer gets a BVH file.</summary>
        public bool AllPerformers
        {
            get => _allPerformers;
            set => _allPerformers = value;
        }

        /// <summary>Gets or sets the performer to export if <see cref="AllPerformers"/> is off.</summary>
        public int PerformerIndex
        {
            get => _performerIndex;
            set => _performerIndex = Mathf.Max(0, value);
        }

        /// <summary>Gets what the recorder does.</summary>
        public RecorderState State => _take is null
            ? _isWaiting ? RecorderState.Waiting : RecorderState.Idle
            : _elapsed.IsRunning ? RecorderState.Recording : RecorderState.Finishing;

        /// <inheritdoc/>
        public override bool IsRecording => State == RecorderState.Recording || State == RecorderState.Waiting;

        /// <inheritdoc/>
        public override double Elapsed => _elapsed.Elapsed.TotalSeconds;

        /// <summary>
        /// Gets the number of frames in the current or last take: rows of its BVH files, or frames received while it was recorded. At most a quarter
        /// of a second old.
        /// </summary>
        public long Frames { get; private set; }

        /// <summary>Gets the size of the current or last take's files, in bytes. At most a quarter of a second old.</summary>
        public long Bytes { get; private set; }

        /// <summary>Gets the full paths of the current or last take's files.</summary>
        public IReadOnlyList<string> Files { get; private set; } = Array.Empty<string>();

        /// <summary>Ends the take. Its files are complete a moment later; see <see cref="Finished"/>.</summary>
        public override void StopRecording()
        {
            _isWaiting = false;
            _elapsed.Stop();
            _take?.Close();
        }

        private protected override string Begin()
        {
            if (State == RecorderState.Finishing)
                return "The last take is still being completed.";
            if (_source == null)
                return "The recorder has no source: set Source.";
            if ((_formats & (TakeFormats.Bvh | TakeFormats.Recording)) == TakeFormats.None)
                return "There is nothing to write: set Formats.";

            _isWaiting = true;
            BeginWhenOpen();
            return "";
        }

        private void Update()
        {
            if (_isWaiting)
                BeginWhenOpen();

            if (_take is null)
                return;

            if (_elapsed.IsRunning && _take.HasEnded)
                StopRecording();

            // Read first: once complete, the other values no longer change.
            bool isComplete = _take.IsComplete;
            Frames = _take.Frames;
            Bytes = _take.Bytes;
            Files = _take.Files;
            if (_take.Problem.Length > 0)
                Problem = _take.Problem;

            if (isComplete)
                Finish();
        }

        private void OnDisable()
        {
            if (IsRecording)
                StopRecording();
        }

        private void OnApplicationQuit()
        {
            StopRecording();
            _take?.WaitForCompletion(LongestWaitAtQuit);
        }

        private void BeginWhenOpen()
        {
            if (_source == null)
            {
                _isWaiting = false;
                Problem = "Nothing is recorded: the source was removed before it was open.";
                return;
            }

            if (!(_source.Reader is { } reader))
                return;

            _isWaiting = false;
            _elapsed.Restart();
            Frames = 0;
            Bytes = 0;
            Files = Array.Empty<string>();
            string folder = Path.Combine(Application.persistentDataPath, _folder);
            TakeLabel label = Label(_source.name);
            _take = new TakeWriter(
                reader,
                _formats,
                _allPerformers ? (int?)null : _performerIndex,
                () => label.Create(folder, TakeWriter.Extensions));
        }

        private void Finish()
        {
            _take = null;
            if (Files.Count > 0)
                CountUp();

            Handlers.Raise(Finished, Files, this);
        }
    }
}
