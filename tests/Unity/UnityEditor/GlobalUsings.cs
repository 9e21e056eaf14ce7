global using UnityEngine;
global using UnityEngine.StandIn;
global using Object = UnityEngine.Object;
