#nullable enable
using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;

namespace NeuronMocap.Unity
{
    // Writes the files of one take. Opening files, completing them and reading their sizes may wait for the disk, so pool threads do it. The main
    // thread only starts the work and reads the results.
    internal sealed class TakeWriter
    {
        private const string BvhExtension = ".bvh";
        private const string RecordingExtension = ".nmrec";
        private static readonly TimeSpan LookPeriod = TimeSpan.FromSeconds(0.25);

        private readonly NeuronReader _reader;
        private readonly TakeFormats _formats;
        private readonly BvhExportOptions _bvhOptions;
        private readonly Func<string> _makePath;
        private readonly Task _opening;
        private Task? _closing;
        private Timer? _looks;
        private volatile BvhExport? _bvh;
        private volatile StreamRecorder? _recording;
        private volatile string _problem = "";
        private volatile string[] _files = Array.Empty<string>();
        private readonly long _framesBefore;
        private long _frames;
        private long _bytes;

        // makePath returns the path without extension, on a pool thread.
        public TakeWriter(NeuronReader reader, TakeFormats formats, int? avatarIndex, Func<string> makePath)
        {
            _reader = reader;
            _formats = formats;
            _makePath = makePath;
            _framesBefore = reader.GetStatistics().MotionFrames;
            _bvhOptions = new BvhExportOptions { AvatarIndex = avatarIndex, FilePerAvatar = avatarIndex is null };
            _opening = Task.Run(Open);
        }

        public static string[] Extensions { get; } = { BvhExtension, RecordingExtension };

        // Empty if there is no problem.
        public string Problem => _problem;

        // The files that were not empty at the last check, at most a quarter of a second ago.
        public IReadOnlyList<string> Files => _files;

        // Rows of all BVH files. With a recording only, the frames received since the start.
        public long Frames => Interlocked.Read(ref _frames);

        public long Bytes => Interlocked.Read(ref _bytes);

        // Ended by itself: the reader closed, or a disk is full.
        public bool HasEnded => _opening.IsCompleted && !IsWriting;

        public bool IsComplete => _closing is { IsCompleted: true };

        private bool IsWriting => _bvh is { Completion: { IsCompleted: false } } || _recording is { IsRecording: true };

        // Returns at once.
        public void Close() => _closing ??= _opening.ContinueWith(
            _ => Complete(),
            CancellationToken.None,
            TaskContinuationOptions.None,
            TaskScheduler.Default);

        public bool WaitForCompletion(TimeSpan longest) => _closing is null || _closing.Wait(longest);

        private void Open()
        {
            string path = "";
            Try("The take cannot start", () =>
            {
                path = _makePath();
                Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            });
            if (_problem.Length > 0)
                return;

            if ((_formats & TakeFormats.Bvh) != TakeFormats.None)
                Try("No BVH file is written", () => _bvh = _reader.ExportBvh(path + BvhExtension, _bvhOptions));
            if ((_formats & TakeFormats.Recording) != TakeFormats.None)
                Try("No recording is written", () => _recording = _reader.StartRecording(path + RecordingExtension));

            _looks = new Timer(_ => Try("The files cannot be checked", Look), null, LookPeriod, LookPeriod);
        }

        private void Complete()
        {
            _looks?.Dispose();
            Try("The BVH file is not complete", () => _bvh?.Dispose());
            Try("The recording is not complete", () => _recording?.Dispose());
            Try("The files cannot be checked", Look);
        }

        private void Look()
        {
            var files = new List<string>();
            long frames = 0;
            long bytes = 0;
            if (_bvh is { } bvh)
            {
                foreach (BvhExportFile file in bvh.Files)
                {
                    files.Add(file.Path);
                    frames += file.FrameCount;
                    bytes += SizeOf(file.Path);
                }

                Note("The BVH file ended early", bvh.Failure);
            }

            if (_recording is { } recording)
            {
                RecordingStatistics statistics = recording.GetStatistics();
                files.Add(recording.CurrentPath);
                if (_bvh is null && recording.IsRecording)
                    frames = _reader.GetStatistics().MotionFrames - _framesBefore;
                else if (_bvh is null)
                    frames = Frames;
                bytes += statistics.WrittenBytes;
                Note("The recording ended early", recording.Failure);
            }

            _files = files.ToArray();
            Interlocked.Exchange(ref _frames, frames);
            Interlocked.Exchange(ref _bytes, bytes);
        }

        private static long SizeOf(string path)
        {
            var file = new FileInfo(path);
            return file.Exists ? file.Length : 0;
        }

        // Reports all exceptions of the file system in the inspector instead of throwing them on the pool.
        private void Try(string what, Action action)
        {
            try
            {
                action();
            }
            catch (Exception exception)
            {
                Note(what, exception);
            }
        }

        private void Note(string what, Exception? exception)
        {
            if (exception is { } && _problem.Length == 0)
                _problem = $"{what}: {exception.Message}";
        }
    }
}
