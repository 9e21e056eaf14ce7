#nullable enable
using NeuronMocap.Server;
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Takes the place of Axis Neuron in this scene: sends a simulated performer on this computer.</summary>
    public sealed class SuitServer : MonoBehaviour
    {
        [SerializeField]
        [Range(0, 65535)]
        [Tooltip("TCP port. 0: a free one.")]
        private int _port = 7001;

        private Broadcaster? _server;

        /// <summary>Gets the port that is served, or 0 if there is no server.</summary>
        public int Port => _server?.LocalEndPoint?.Port ?? 0;

        private void OnEnable()
        {
            var server = new Broadcaster(new BroadcasterOptions { Sources = new MotionSource[] { new SyntheticSource() }, Port = _port });
            try
            {
                server.Start();
                _server = server;
            }
            catch (NeuronException exception)
            {
                server.Dispose();
                Debug.LogWarning($"{exception.Message} If Axis Neuron runs on this computer, the scene receives from it.", this);
            }
        }

        private void OnDisable()
        {
            _server?.Dispose();
            _server = null;
        }
    }
}
