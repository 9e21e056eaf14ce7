#nullable enable

using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    // The sources of a file, one for each address. In a scene, a new source gets its own object. A prefab cannot refer to an object of a scene, so its
    // source is on the object of the first component that uses it. Sources with equal settings share one connection.
    internal sealed class SourcePlacement
    {
        private readonly MigrationFile _file;
        private readonly Dictionary<SourceAddress, MocapSource> _sources = new Dictionary<SourceAddress, MocapSource>();
        private readonly HashSet<SourceAddress> _planned = new HashSet<SourceAddress>();
        private readonly HashSet<GameObject> _taken = new HashSet<GameObject>();

        public SourcePlacement(MigrationFile file)
        {
            _file = file;
            foreach (MocapSource source in file.FindComponents<MocapSource>())
            {
                _taken.Add(source.gameObject);
                if (SourceAddress.Of(source) is { } address && !_sources.ContainsKey(address))
                    _sources.Add(address, source);
            }
        }

        // Why there can be no source for an object. Empty if there can.
        public string FindObstacle(SourceAddress address, GameObject user)
        {
            bool needsUser = _file.Scene == null && !_sources.ContainsKey(address) && !_planned.Contains(address);
            return needsUser && _taken.Contains(user)
                ? "Its object already has a Mocap Source with other settings."
                : string.Empty;
        }

        // Whether the source is new.
        public bool Plan(SourceAddress address, GameObject user)
        {
            if (_sources.ContainsKey(address) || !_planned.Add(address))
                return false;

            _taken.Add(user);
            return true;
        }

        public MocapSource Create(SourceAddress address, GameObject user)
        {
            if (_sources.TryGetValue(address, out MocapSource? known))
                return known;

            MocapSource source = _file.Scene is { } scene ? CreateObject(address, scene) : Undo.AddComponent<MocapSource>(user);
            address.CopyTo(source);
            EditorUtility.SetDirty(source);
            _sources.Add(address, source);
            return source;
        }

        private static MocapSource CreateObject(SourceAddress address, Scene scene)
        {
            var created = new GameObject($"Mocap Source {address}");
            SceneManager.MoveGameObjectToScene(created, scene);
            Undo.RegisterCreatedObjectUndo(created, "Create Mocap Source");
            return created.AddComponent<MocapSource>();
        }
    }
}
