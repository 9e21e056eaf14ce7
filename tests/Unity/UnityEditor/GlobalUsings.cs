global using UnityEngine;
global using UnityEngine.StandIn;
