global using NeuronMocap.Tests.Infrastructure;
global using Xunit;
