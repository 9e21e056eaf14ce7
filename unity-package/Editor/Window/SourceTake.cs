#nullable enable
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // A take of the Sources window: files of what a source receives, and clips of the characters that it moves.
    internal sealed class SourceTake : IDisposable
    {
        private readonly MocapSource _source;
        private readonly string _name;
        private readonly TakeWriter? _files;
        private readonly List<ClipRecorder> _clips = new List<ClipRecorder>();
        private readonly Stopwatch _elapsed = Stopwatch.StartNew();
        private readonly List<string> _saved = new List<string>();
        private string _problem = "";

        // folder: of the files.
        public SourceTake(MocapSource source, TakeSettings settings, string folder)
        {
            _source = source;
            _name = settings.TakeNextName();
            string name = _name;
            string label = source.name;
            DateTime now = DateTime.Now;
            if (source.Reader is { } reader && FormatsOf(source, settings) is var formats && formats != TakeFormats.None)
                _files = new TakeWriter(reader, formats, null, () => TakeFileName.Create(folder, name, label, now, TakeWriter.Extensions));

            if (settings.Clips && !Application.isPlaying)
                _problem = "Clips are recorded in play mode only.";
            else if (settings.Clips)
                AddClips(source, settings.ClipKind);
            if (_files is null && _clips.Count == 0 && _problem.Length == 0)
                _problem = "There is nothing to record: no format is chosen, or the source moves no character.";
            if (_files is null && _clips.Count == 0)
                _elapsed.Stop();
        }

        public bool IsRunning => _elapsed.IsRunning;

        public IReadOnlyList<string> Files => _files?.Files ?? Array.Empty<string>();

        // The paths of the saved clips.
        public IReadOnlyList<string> Clips => _saved;

        public string Problem => _problem.Length > 0 ? _problem : _files?.Problem ?? "";

        // The stream of a recording is in a file already.
        public static TakeFormats FormatsOf(MocapSource source, TakeSettings settings) =>
            source.Kind == SourceKind.Recording ? TakeFormats.None : settings.Formats;

        // Once per repaint. A take also ends with its source.
        public void Update()
        {
            bool isOver = _files is { } files ? files.HasEnded : !_clips.Any(clip => clip != null && clip.IsRecording);
            if (IsRunning && (isOver || _source == null || !_source.IsOpen))
                Stop();
        }

        // Text for the row under the buttons.
        public string Describe()
        {
            var parts = new List<string> { $"{PerformerRow.Number(_elapsed.Elapsed.TotalSeconds, "0.0")} s" };
            if (_files is { } files)
            {
                parts.Add($"{PerformerRow.Number(files.Frames, "#,0")} frames");
                parts.Add($"{PerformerRow.Number(files.Bytes / 1e6, "0.0")} MB");
            }

            int clips = IsRunning ? _clips.Count : _saved.Count;
            if (clips > 0)
                parts.Add(clips == 1 ? "1 clip" : $"{clips} clips");

            string state = IsRunning ? "Recording" : _files is { IsComplete: false } ? "Completing" : "Recorded";
            return $"{state} {_name}: {string.Join(", ", parts)}";
        }

        public void Stop()
        {
            if (!IsRunning)
                return;

            _elapsed.Stop();
            _files?.Close();
            foreach (ClipRecorder clip in _clips)
            {
                // The recorder of a character that was destroyed has saved its clip by itself.
                clip.StopRecording();
                if (clip.SavedPath.Length > 0)
                    _saved.Add(clip.SavedPath);
                else if (clip != null)
                    Note(clip);

                if (clip != null)
                    UnityEngine.Object.DestroyImmediate(clip);
            }
        }

        public void Dispose() => Stop();

        private void AddClips(MocapSource source, ClipKind kind)
        {
            foreach (FigureDriver driver in Resources.FindObjectsOfTypeAll<FigureDriver>().Where(driver => driver.IsDriving && driver.ActiveSource == source))
            {
                ClipRecorder clip = driver.gameObject.AddComponent<ClipRecorder>();
                clip.hideFlags = HideFlags.DontSave | HideFlags.HideInInspector;
                clip.FileName = $"{_name} {driver.name}";
                clip.Kind = driver is HumanoidDriver ? kind : ClipKind.Generic;
                clip.Animator = driver is HumanoidDriver humanoid ? humanoid.ActiveAnimator : null;
                clip.Hips = driver is HumanoidDriver ? null : driver.FindHips();
                if (clip.StartRecording())
                {
                    _clips.Add(clip);
                    continue;
                }

                Note(clip);
                UnityEngine.Object.DestroyImmediate(clip);
            }
        }

        private void Note(ClipRecorder clip)
        {
            if (_problem.Length == 0)
                _problem = $"No clip of \"{clip.name}\": {clip.Problem}";
        }
    }
}
