package org.selectiverenderer.browser.nodes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.tessellate.Tessellator;

class NodeFactoryTest {
  private final NodeFactory factory = new NodeFactory();

  @Test
  void aNodeOfEveryTypeCanBeMade() {
    for (NodeType type : TestNodes.CATALOGUE.all()) {
      assertThat(factory.make(type, null, SourceLocation.of("test")).type()).isSameAs(type);
    }
  }

  @Test
  void whatIsTessellatedCountsAsActedOnAndNoOtherGeometryDoes() {
    Tessellator tessellator = new Tessellator();
    for (NodeType type : TestNodes.CATALOGUE.all()) {
      if (type.is("X3DGeometryNode")) {
        assertThat(factory.actsOn(type)).as(type.name()).isEqualTo(tessellator.handles(type));
      }
    }
  }

  /** A change of what the runtime does with node types is to be seen here. */
  @Test
  void theTypesThatAreOnlyKept() {
    assertThat(kept())
        .isEqualTo(
            """
            Core: ProtoInstance
            DIS: DISEntityManager DISEntityTypeMapping ReceiverPdu SignalPdu TransmitterPdu
            NURBS: NurbsSet
            RigidBodyPhysics: BallJoint CollisionCollection CollisionSensor CollisionSpace Contact \
            DoubleAxisHingeJoint MotorJoint RigidBody RigidBodyCollection SingleAxisHingeJoint SliderJoint \
            UniversalJoint
            Shape: AcousticProperties
            Sound: Analyser AudioDestination BiquadFilter BufferAudioSource ChannelMerger ChannelSelector \
            ChannelSplitter Convolver Delay DynamicsCompressor Gain ListenerPointSource MicrophoneSource \
            OscillatorSource PeriodicWave SpatialSound StreamAudioDestination StreamAudioSource WaveShaper
            TextureProjection: all
            VolumeRendering: all
            """);
  }

  private String kept() {
    Map<String, List<NodeType>> components =
        TestNodes.CATALOGUE.all().stream()
            .collect(Collectors.groupingBy(NodeType::component, TreeMap::new, Collectors.toList()));
    StringBuilder text = new StringBuilder();
    components.forEach(
        (component, types) -> {
          List<NodeType> kept = types.stream().filter(type -> !factory.actsOn(type)).toList();
          if (kept.size() == types.size()) {
            text.append(component).append(": all\n");
          } else if (!kept.isEmpty()) {
            text.append(component)
                .append(
                    kept.stream().map(NodeType::name).collect(Collectors.joining(" ", ": ", "\n")));
          }
        });
    return text.toString();
  }
}
