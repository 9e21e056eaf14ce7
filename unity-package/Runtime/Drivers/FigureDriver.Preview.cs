#nullable enable

using System;
using System.Collections.Generic;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Edit mode: the figure moves, but its pose in the scene is kept and comes back.
    public abstract partial class FigureDriver
    {
        // The figure, and what root motion has moved, before it was moved in edit mode. Other places are the user's, who may move the figure meanwhile.
        [NonSerialized]
        private List<(Transform Node, Vector3 Position, Quaternion Rotation)>? _scenePose;

        [NonSerialized]
        private bool _isPreviewed;

        // Whether the figure follows its performer in edit mode.
        internal bool IsPreviewed => _isPreviewed;

        // In edit mode, instead of Update and LateUpdate.
        internal void Preview()
        {
            _isPreviewed = true;
            if (!IsPosed && TryBind())
                SaveScene(_rig!);

            Drive();
        }

        internal void EndPreview()
        {
            if (!_isPreviewed)
                return;

            _isPreviewed = false;
            OnDisable();
            Rebind();
            Problem = string.Empty;
        }

        private void SaveScene(FigureRig rig)
        {
            if (Application.isPlaying || _scenePose != null)
                return;

            _scenePose = new List<(Transform Node, Vector3 Position, Quaternion Rotation)>(rig.Nodes.Length);
            foreach (Transform node in rig.Nodes)
                Save(node);
        }

        // Before root motion moves an object that carries the figure.
        private void SaveCarrier(Transform carrier)
        {
            if (_scenePose is null)
                return;

            foreach ((Transform node, _, _) in _scenePose)
            {
                if (node == carrier)
                    return;
            }

            Save(carrier);
        }

        private void Save(Transform node)
        {
            if (node != null)
                _scenePose!.Add((node, node.localPosition, node.localRotation));
        }

        private void RestoreScene()
        {
            if (_scenePose is null)
                return;

            foreach ((Transform node, Vector3 position, Quaternion rotation) in _scenePose)
            {
                if (node != null)
                    (node.localPosition, node.localRotation) = (position, rotation);
            }

            _scenePose = null;
        }
    }
}
