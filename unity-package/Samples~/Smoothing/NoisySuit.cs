#nullable enable
using System;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using UnityEngine;
using Quaternion = System.Numerics.Quaternion;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>A server for a suit whose sensors tremble, on this computer. The source receives from it as from Axis Neuron.</summary>
    public sealed class NoisySuit : MonoBehaviour
    {
        private const float MostNoise = 5;

        [SerializeField]
        [Tooltip("The source that receives the motion. It is disabled in the scene, and enabled when the port of the server is known.")]
        private MocapSource? _source;

        [SerializeField]
        [Range(0, MostNoise)]
        [Tooltip("How far each joint trembles, in degrees.")]
        private float _noise = 2;

        private readonly NoisyMotion _motion = new NoisyMotion();
        private Broadcaster? _server;

        /// <summary>Gets or sets the source that receives the motion. Set it before the component is enabled.</summary>
        public MocapSource? Source
        {
            get => _source;
            set => _source = value;
        }

        /// <summary>Gets or sets how far each joint trembles, 0 to 5 degrees.</summary>
        public float Noise
        {
            get => _noise;
            set => _noise = _motion.Degrees = Mathf.Clamp(value, 0, MostNoise);
        }

        private void OnEnable()
        {
            Noise = _noise;
            _server = new Broadcaster(new BroadcasterOptions { Sources = new MotionSource[] { _motion }, Port = 0 });
            _server.Start();
            if (_source == null)
                return;

            _source.Kind = SourceKind.Network;
            _source.Address = "127.0.0.1";
            _source.Port = _server.LocalEndPoint!.Port;
            _source.enabled = true;
        }

        private void OnDisable()
        {
            if (_source != null)
                _source.enabled = false;

            _server?.Dispose();
            _server = null;
        }

        private void OnValidate() => _motion.Degrees = _noise;

        // Clicks on the buttons below need the old Input Manager.
        private void Update()
        {
            if (KeyPresses.IsPressed(KeyCode.M))
                Noise++;
            if (KeyPresses.IsPressed(KeyCode.L))
                Noise--;
        }

        private void OnGUI()
        {
            GUILayout.BeginArea(new Rect(10, 60, 260, 100));
            GUILayout.Label($"Left: as it comes, with noise of {_noise:0.0} degrees. Right: smoothed.");
            if (GUILayout.Button("More noise (key M)"))
                Noise++;
            if (GUILayout.Button("Less noise (key L)"))
                Noise--;

            GUILayout.EndArea();
        }

        // The simulator's walk, with noise on the rotation of each bone. The server calls it on its own thread.
        private sealed class NoisyMotion : MotionSource
        {
            private const float RadiansPerDegree = (float)Math.PI / 180;

            private readonly SyntheticSource _walk = new SyntheticSource();
            private volatile float _degrees;

            public float Degrees
            {
                get => _degrees;
                set => _degrees = value;
            }

            public override double FrameRate => _walk.FrameRate;

            public override long? FrameCount => null;

            public override bool HasDisplacement => true;

            public override void GetPose(long frame, Span<BoneTransform> pose)
            {
                _walk.GetPose(frame, pose);
                for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
                {
                    var noise = Quaternion.CreateFromYawPitchRoll(Noise(frame, bone, 0), Noise(frame, bone, 1), Noise(frame, bone, 2));
                    pose[bone] = new BoneTransform(pose[bone].Position, pose[bone].Rotation * noise);
                }
            }

            public override FootContacts GetFootContacts(long frame) => _walk.GetFootContacts(frame);

            // A source returns the same pose for a frame every time, so the noise depends on the numbers alone.
            private float Noise(long frame, int bone, int axis)
            {
                uint mix = unchecked((((uint)frame * 59) + (uint)bone) * 3 + (uint)axis);
                mix = unchecked((mix ^ (mix >> 16)) * 0x7FEB352D);
                mix = unchecked((mix ^ (mix >> 15)) * 0x846CA68B);
                mix ^= mix >> 16;
                return ((mix / (float)uint.MaxValue * 2) - 1) * _degrees * RadiansPerDegree;
            }
        }
    }
}
