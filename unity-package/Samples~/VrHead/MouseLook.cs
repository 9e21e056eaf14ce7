#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Stands in for a headset: turns this object while a mouse button is held. Works with either input system.</summary>
    public sealed class MouseLook : MonoBehaviour
    {
        private const float SteepestPitch = 80;

        [SerializeField]
        [Range(0.05f, 1)]
        [Tooltip("Degrees per pixel.")]
        private float _speed = 0.25f;

        private float _yaw;
        private float _pitch;

        /// <summary>Turns by so much.</summary>
        /// <param name="yaw">Degrees to the right.</param>
        /// <param name="pitch">Degrees downwards.</param>
        public void Turn(float yaw, float pitch)
        {
            _yaw += yaw;
            _pitch = Mathf.Clamp(_pitch + pitch, -SteepestPitch, SteepestPitch);
            transform.localRotation = Quaternion.Euler(_pitch, _yaw, 0);
        }

        private void OnGUI()
        {
            GUILayout.Label("Hold a mouse button and move to look around: in place of a headset.");
            Event now = Event.current;
            if (now.type == EventType.MouseDrag)
                Turn(now.delta.x * _speed, now.delta.y * _speed);
        }
    }
}
