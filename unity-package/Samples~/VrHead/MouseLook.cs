#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>
    /// Replaces a headset: the arrow keys turn this object, and so does the mouse while a button is held. The mouse needs the old Input Manager.
    /// </summary>
    public sealed class MouseLook : MonoBehaviour
    {
        private const float SteepestPitch = 80;

        // Degrees for each press of a key.
        private const float Step = 10;

#if ENABLE_LEGACY_INPUT_MANAGER
        private const string Advice = "Hold a mouse button and move the mouse, or press the arrow keys, to look around.";
#else
        private const string Advice = "Press the arrow keys to look around.";
#endif

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

        private void Update()
        {
            int right = Press(KeyCode.RightArrow) - Press(KeyCode.LeftArrow);
            int down = Press(KeyCode.DownArrow) - Press(KeyCode.UpArrow);
            if (right != 0 || down != 0)
                Turn(right * Step, down * Step);
        }

        private static int Press(KeyCode key) => KeyPresses.IsPressed(key) ? 1 : 0;

        private void OnGUI()
        {
            GUILayout.Label(Advice);
            Event now = Event.current;
            if (now.type == EventType.MouseDrag)
                Turn(now.delta.x * _speed, now.delta.y * _speed);
        }
    }
}
