#nullable enable
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // What the Sources window records, and the slate of the next take. Each user of the project has their own.
    [FilePath("UserSettings/NeuronMocapTakes.asset", FilePathAttribute.Location.ProjectFolder)]
    internal sealed class TakeSettings : ScriptableSingleton<TakeSettings>
    {
        [SerializeField, Tooltip("Name of the next take. Its files have this name and the slate.")]
        private string _takeName = TakeLabel.DefaultName;

        [SerializeField, Min(1), Tooltip("Number of the next take. Counts up with each take.")]
        private int _slate = 1;

        [SerializeField, Tooltip("What to write of the stream, into the folder Recordings beside Assets.")]
        private TakeFormats _formats = TakeFormats.Recording;

        [SerializeField, Tooltip("Also record an animation clip of each character that the source moves, into Assets/Recordings.")]
        private bool _clips;

        [SerializeField, Tooltip("Humanoid clips play on every Humanoid. Generic clips are exact and play on the same transforms only.")]
        private ClipKind _clipKind = ClipKind.Humanoid;

        public string TakeName
        {
            get => _takeName;
            set => _takeName = value;
        }

        public int Slate
        {
            get => _slate;
            set => _slate = value;
        }

        public TakeFormats Formats
        {
            get => _formats;
            set => _formats = value;
        }

        public bool Clips
        {
            get => _clips;
            set => _clips = value;
        }

        public ClipKind ClipKind
        {
            get => _clipKind;
            set => _clipKind = value;
        }

        // Name and slate of the next take.
        public string NextName => new TakeLabel("{name} {take}", "", _takeName, _slate, default).First;

        // Returns the name of the take that starts now.
        public string TakeNextName()
        {
            string taken = NextName;
            _slate = Mathf.Max(1, _slate) + 1;
            Save(true);
            return taken;
        }

        public void Save() => Save(true);
    }
}
