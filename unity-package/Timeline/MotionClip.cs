#nullable enable

using System;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace NeuronMocap.Unity.Timeline
{
    /// <summary>A clip of a <see cref="MotionTrack"/>: a BVH file or a recording. The pose at a time is that of the file, in play mode and in edit mode.</summary>
    public sealed class MotionClip : PlayableAsset, ITimelineClipAsset
    {
        [Tooltip("A BVH file (.bvh) or a recording: an absolute path, or one relative to the StreamingAssets folder.")]
        [SerializeField]
        private string _file = string.Empty;

        [Tooltip("A BVH file or a recording as a text asset, with the extension .txt or .bytes. It takes precedence over File.")]
        [SerializeField]
        private TextAsset? _fileAsset;

        [Tooltip("Number of the performer in a recording. -1: the first one.")]
        [Min(-1)]
        [SerializeField]
        private int _performerIndex = -1;

        [NonSerialized]
        private MotionTake? _take;

        [NonSerialized]
        private (string File, TextAsset? Asset, int Performer) _loaded;

        /// <summary>Gets or sets the path of a BVH file or a recording: absolute, or relative to <c>Application.streamingAssetsPath</c>.</summary>
        public string File
        {
            get => _file;
            set => _file = value ?? string.Empty;
        }

        /// <summary>Gets or sets a BVH file or a recording as a text asset. It takes precedence over <see cref="File"/>.</summary>
        public TextAsset? FileAsset
        {
            get => _fileAsset;
            set => _fileAsset = value;
        }

        /// <summary>Gets or sets the number of the performer in a recording. The default, -1, is the first one.</summary>
        public int PerformerIndex
        {
            get => _performerIndex;
            set => _performerIndex = value;
        }

        /// <summary>Gets why the clip has no motion, and the setting to change. Empty if there is no problem.</summary>
        public string Problem { get; private set; } = string.Empty;

        /// <summary>Gets what Timeline can do with the clip: blend it, start it later in the file, and change its speed.</summary>
        public ClipCaps clipCaps => ClipCaps.Blending | ClipCaps.ClipIn | ClipCaps.SpeedMultiplier;

        /// <summary>Gets the duration of the file, in seconds.</summary>
        public override double duration => Load()?.Duration ?? base.duration;

        /// <summary>Creates the playable of the clip, and reads the file if it was not read before.</summary>
        /// <param name="graph">The graph.</param>
        /// <param name="owner">The object of the director.</param>
        /// <returns>The playable.</returns>
        public override Playable CreatePlayable(PlayableGraph graph, GameObject owner)
        {
            ScriptPlayable<MotionClipBehaviour> playable = ScriptPlayable<MotionClipBehaviour>.Create(graph);
            playable.GetBehaviour().Take = Load();
            if (Problem.Length > 0)
                Debug.LogWarning(Problem, this);

            return playable;
        }

        internal string FileName => _fileAsset != null ? _fileAsset.name : _file.Trim();

        /// <summary>Reads the file again. Call it after the file has changed.</summary>
        public void Reload()
        {
            _loaded = default;
            Load();
        }

        // A file is read once, also if it cannot be used.
        internal MotionTake? Load()
        {
            var wanted = (_file.Trim(), _fileAsset, _performerIndex);
            if (_loaded.File != null && _loaded == wanted)
                return _take;

            _loaded = wanted;
            (_take, Problem) = (null, string.Empty);
            if (_fileAsset == null && wanted.Item1.Length == 0)
            {
                Problem = "The clip has no file. Enter its path in File, or assign a text asset.";
                return null;
            }

            try
            {
                _take = _fileAsset != null ? MotionTake.Parse(_fileAsset.bytes, _performerIndex) : MotionTake.Load(SourceFiles.Resolve(wanted.Item1), _performerIndex);
            }
            catch (Exception exception) when (!(exception is OutOfMemoryException))
            {
                // Whatever is wrong with the file, Timeline must go on with the other clips.
                Problem = $"The file {FileName} cannot be used: {exception.Message}";
            }

            return _take;
        }
    }
}
