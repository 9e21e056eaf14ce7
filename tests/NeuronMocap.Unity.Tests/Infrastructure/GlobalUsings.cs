global using NeuronMocap.Tests.Infrastructure;
global using UnityEngine;
global using UnityEngine.StandIn;
global using Xunit;
global using Object = UnityEngine.Object;
