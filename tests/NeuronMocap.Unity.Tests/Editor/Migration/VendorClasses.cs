#pragma warning disable CA1050, CA1051, MA0047 // Namespaces and public fields as scenes of the vendor's integration have them.

public class NeuronAnimatorInstance : Neuron.NeuronInstance
{
    public Animator? boundAnimator;
    public bool physicalUpdate;
    public bool enableHipsMovement = true;
}

public class NeuronInstancesManager : MonoBehaviour
{
    public GameObject? replicaPrefab;
}

public class RewrittenInstance : NeuronAnimatorInstance
{
}

[RequireComponent(typeof(NeuronAnimatorInstance))]
public class InstanceUser : MonoBehaviour
{
}

namespace Neuron
{
    public enum SocketKind
    {
        TCP,
        UDP,
    }

    public class NeuronInstance : MonoBehaviour
    {
        public string address = "127.0.0.1";
        public int port = 7001;
        public SocketKind socketType;
        public int actorID;
        public bool connectToAxis = true;
        public float hipHeightOffset = 0.035f;
    }

    public class NeuronTransformsInstance : NeuronInstance
    {
        public Transform? root;
        public string prefix = "Robot_";
        public bool useNewRig = true;
    }
}
