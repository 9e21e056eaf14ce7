#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Replaces a headset: turns this object while a mouse button is held. Works with both input systems.</summary>
    public sealed class MouseLook : MonoBehaviour
    {
        private const float SteepestPitch = 80;

        [SerializeField]
        [Range(0.05f, 1)]
        [Tooltip("Degrees per pixel.")]
        private float _speed = 0.25f;

        private float _yaw;
        private float _pitch;

        /// <summary>Turns the object.</summary>
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
            GUILayout.Label("Hold a mouse button and move the mouse to look around, instead of with a headset.");
            Event now = Event.current;
            if (now.type == EventType.MouseDrag)
                Turn(now.delta.x * _speed, now.delta.y * _speed);
        }
    }
}
