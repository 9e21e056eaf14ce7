#nullable enable

using System;
using System.Globalization;
using System.IO;
using System.Linq;
using NeuronMocap.Recording;

namespace NeuronMocap.Unity.EditorTools
{
    // A recording of everything that a source receives, started with one click. The file name is chosen automatically.
    internal sealed class SourceRecording : IDisposable
    {
        private readonly StreamRecorder _recorder;

        private SourceRecording(StreamRecorder recorder) => _recorder = recorder;

        public string FilePath => _recorder.Path;

        public bool IsRunning => _recorder.IsRecording;

        // Text for the row under the buttons.
        public string Describe()
        {
            if (_recorder.Failure is { } failure)
                return $"The recording ended: {failure.Message}";

            RecordingStatistics figures = _recorder.GetStatistics();
            string size = $"{PerformerRow.Number(figures.Duration.TotalSeconds, "0.0")} s, {PerformerRow.Number(figures.Bytes / 1e6, "0.0")} MB";
            string lost = figures.LostBytes > 0 ? $"; the disk was too slow for {PerformerRow.Number(figures.LostBytes, "#,0")} bytes" : string.Empty;
            return $"{(IsRunning ? "Recording to" : "Recorded")} {Path.GetFileName(FilePath)}: {size}{lost}";
        }

        // Creates the folder if it does not exist.
        public static SourceRecording Start(NeuronReader reader, string folder, string name, DateTime now)
        {
            Directory.CreateDirectory(folder);
            string safe = new string(name.Select(letter => Path.GetInvalidFileNameChars().Contains(letter) ? '_' : letter).ToArray());
            string file = $"{safe}-{now.ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture)}.nmrec";
            return new SourceRecording(reader.StartRecording(Path.Combine(folder, file)));
        }

        public void Dispose() => _recorder.Dispose();
    }
}
