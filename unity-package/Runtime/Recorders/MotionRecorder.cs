#nullable enable
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Records what a <see cref="MocapSource"/> receives, at run time, in the editor and in players: BVH files, or recordings that play again as the live stream
    /// did. Other threads write; the main thread never waits for the disk. A take ends with <see cref="StopRecording"/>, with the component or the source, and when the
    /// application quits; a process that is killed leaves files that open.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Motion Recorder")]
    public sealed class MotionRecorder : MonoBehaviour
    {
        // A file is complete long before, unless the disk is very slow; and one that is not still opens.
        private static readonly TimeSpan LongestWaitAtQuit = TimeSpan.FromMilliseconds(100);

        [SerializeField]
        [Tooltip("The source whose motion is recorded.")]
        private MocapSource? _source;

        [SerializeField]
        [Tooltip("BVH opens in animation programs. A recording keeps every byte with its time and plays again as the live stream did.")]
        private TakeFormats _formats = TakeFormats.Bvh;

        [SerializeField]
        [Tooltip("Folder of the files. Empty: the application's data folder. A relative path begins there.")]
        private string _folder = "";

        [SerializeField]
        [Tooltip("Name of the files without extension. {source}, {date}, {time} and {take} (001, 002 ...) are replaced.")]
        private string _fileName = TakeFileName.DefaultPattern;

        [SerializeField]
        [Tooltip("A BVH file for each performer; otherwise for one only.")]
        private bool _allPerformers = true;

        [SerializeField]
        [Min(0)]
        [Tooltip("Number on the server of the performer to export to BVH, unless all are exported.")]
        private int _avatarIndex;

        [SerializeField]
        [Tooltip("Begin a take when play mode, or the scene, begins.")]
        private bool _recordOnPlay;

        private readonly Stopwatch _elapsed = new Stopwatch();
        private TakeWriter? _take;
        private bool _isWaiting;

        /// <summary>
        /// A take's files are complete. Main thread; the files' full paths. Raised in Update: of a take that ended because the component was disabled, once it is
        /// enabled again; of one that ended with its object or the application, never, though its files are completed all the same.
        /// </summary>
        public event Action<IReadOnlyList<string>>? Finished;

        /// <summary>The source whose motion is recorded.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>What is written. Of the next take.</summary>
        public TakeFormats Formats
        {
            get => _formats;
            set => _formats = value;
        }

        /// <summary>
        /// Where the files of the next take go. Empty: <see cref="Application.persistentDataPath"/>, where a relative path begins, too. The folder is made.
        /// </summary>
        public string Folder
        {
            get => _folder;
            set => _folder = value ?? "";
        }

        /// <summary>Name of the next take's files: a pattern for <see cref="TakeFileName"/>.</summary>
        public string FileName
        {
            get => _fileName;
            set => _fileName = value ?? "";
        }

        /// <summary>Whether every performer gets a BVH file.</summary>
        public bool AllPerformers
        {
            get => _allPerformers;
            set => _allPerformers = value;
        }

        /// <summary>The performer to export when not <see cref="AllPerformers"/> is.</summary>
        public int AvatarIndex
        {
            get => _avatarIndex;
            set => _avatarIndex = Mathf.Max(0, value);
        }

        /// <summary>Whether a take begins with play mode, or with the scene.</summary>
        public bool RecordOnPlay
        {
            get => _recordOnPlay;
            set => _recordOnPlay = value;
        }

        /// <summary>What the recorder does.</summary>
        public RecorderState State => _take is null
            ? _isWaiting ? RecorderState.Waiting : RecorderState.Idle
            : _elapsed.IsRunning ? RecorderState.Recording : RecorderState.Finishing;

        /// <summary>How long this take has run, or the last one ran; seconds.</summary>
        public double Elapsed => _elapsed.Elapsed.TotalSeconds;

        /// <summary>Frames in this take or the last one: rows of its BVH files, or received while it was recorded. At most a quarter of a second old.</summary>
        public long Frames { get; private set; }

        /// <summary>Size of this take's files, or of the last one's; bytes. At most a quarter of a second old.</summary>
        public long Bytes { get; private set; }

        /// <summary>Full paths of this take's files, or of the last one's.</summary>
        public IReadOnlyList<string> Files { get; private set; } = Array.Empty<string>();

        /// <summary>Why nothing is recorded, or not all of it; empty while all is well.</summary>
        public string Problem { get; private set; } = "";

        /// <summary>
        /// Begins a take. Where the source is not open yet, the take waits for it.
        /// </summary>
        /// <returns>False when it cannot begin; <see cref="Problem"/> says why.</returns>
        [ContextMenu("Start recording")]
        public bool StartRecording()
        {
            if (State != RecorderState.Idle)
                return Refuse(State == RecorderState.Finishing ? "The last take is still being completed." : "A take is being recorded already.");
            if (!isActiveAndEnabled)
                return Refuse("The recorder is disabled.");
            if (_source == null)
                return Refuse("The recorder has no source: set Source.");
            if ((_formats & (TakeFormats.Bvh | TakeFormats.Recording)) == TakeFormats.None)
                return Refuse("Nothing is to be written: set Formats.");

            Problem = "";
            _isWaiting = true;
            BeginWhenOpen();
            return true;
        }

        /// <summary>Ends the take. Its files are complete a moment later: <see cref="Finished"/>.</summary>
        [ContextMenu("Stop recording")]
        public void StopRecording()
        {
            _isWaiting = false;
            _elapsed.Stop();
            _take?.Close();
        }

        private void Start()
        {
            if (_recordOnPlay)
                StartRecording();
        }

        private void Update()
        {
            if (_isWaiting)
                BeginWhenOpen();

            if (_take is null)
                return;

            if (_elapsed.IsRunning && _take.HasEnded)
                StopRecording();

            // First: what is complete does not change any more.
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
            if (State == RecorderState.Waiting || State == RecorderState.Recording)
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
            string pattern = _fileName;
            string label = _source.name;
            DateTime now = DateTime.Now;
            _take = new TakeWriter(
                reader,
                _formats,
                _allPerformers ? (int?)null : _avatarIndex,
                () => TakeFileName.Create(folder, pattern, label, now, TakeWriter.Extensions));
        }

        private void Finish()
        {
            _take = null;
            Finished?.Invoke(Files);
        }

        private bool Refuse(string reason)
        {
            Problem = reason;
            return false;
        }
    }
}
