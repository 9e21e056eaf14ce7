#nullable enable

using UnityEngine;

namespace NeuronMocap.Unity
{
    // Where the root stood in the first sample of a take. A clip is played on a root that stays, so the way of a root that moves belongs to the clip.
    internal sealed class TakeOrigin
    {
        private readonly Transform _root;
        private Vector3 _position;
        private Quaternion _rotation;
        private bool _hasBegun;

        public TakeOrigin(Transform root) => _root = root;

        // Once for each sample, before the other members.
        public void Follow()
        {
            if (_hasBegun)
                return;

            (_position, _rotation, _hasBegun) = (_root.position, _root.rotation, true);
        }

        // The take began at the place of another root.
        public void Continue(TakeOrigin before) => (_position, _rotation, _hasBegun) = (before._position, before._rotation, before._hasBegun);

        // A place in the space of the root, relative to where the root stood.
        public Vector3 ToStart(Vector3 position)
        {
            Vector3 turned = Quaternion.Inverse(_rotation) * (_root.TransformPoint(position) - _position);
            Vector3 size = _root.lossyScale;
            return new Vector3(turned.x / size.x, turned.y / size.y, turned.z / size.z);
        }

        public Quaternion ToStart(Quaternion rotation) => Quaternion.Inverse(_rotation) * _root.rotation * rotation;
    }
}
