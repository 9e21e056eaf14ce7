#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>
    /// Put this on an empty object and press Play. It creates ground, light, camera, a figure, and a performer who walks and waves.
    /// </summary>
    public sealed class QuickStart : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Off: motion from Axis Neuron or Axis Studio, at the address below.")]
        private bool _useSimulator = true;

        [SerializeField]
        [Tooltip("The computer that runs Axis Neuron or Axis Studio.")]
        private string _address = "127.0.0.1";

        [SerializeField]
        [Range(1, 65535)]
        [Tooltip("Port, as in the broadcasting settings of Axis Neuron or Axis Studio.")]
        private int _port = 7001;

        [SerializeField]
        [Tooltip("TCP or UDP, as in the broadcasting settings of Axis Neuron or Axis Studio.")]
        private TransportKind _transport = TransportKind.Tcp;

        /// <summary>Gets or sets whether the motion is simulated. Otherwise it comes over the network.</summary>
        public bool UseSimulator
        {
            get => _useSimulator;
            set => _useSimulator = value;
        }

        /// <summary>Gets the source of the motion.</summary>
        public MocapSource? Source { get; private set; }

        /// <summary>Gets the builder of the figure.</summary>
        public FigureBuilder? Builder { get; private set; }

        private void Start()
        {
            Source = CreateSource();
            Builder = CreateFigure(Source);
            gameObject.AddComponent<StageBuilder>().Target = Builder.transform;
        }

        private MocapSource CreateSource()
        {
            var holder = new GameObject("Mocap Source");
            holder.transform.SetParent(transform, false);

            // Inactive until everything is set, so that the source opens only once.
            holder.SetActive(false);
            MocapSource source = holder.AddComponent<MocapSource>();
            source.Kind = _useSimulator ? SourceKind.Simulator : SourceKind.Network;
            source.Address = _address;
            source.Port = _port;
            source.Transport = _transport;
            holder.SetActive(true);
            return source;
        }

        private FigureBuilder CreateFigure(MocapSource source)
        {
            var holder = new GameObject("Figure");
            holder.transform.SetParent(transform, false);
            HumanoidDriver driver = holder.AddComponent<HumanoidDriver>();
            driver.Source = source;
            return holder.AddComponent<FigureBuilder>();
        }
    }
}
