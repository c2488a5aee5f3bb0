package org.selectiverenderer.authoring.routes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.routes.SceneRoute.Fault;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

class SceneRouteTest {
  private static final String SCENE =
      """
      <X3D version='3.3'>
        <Scene>
          <ProtoDeclare name='Fan'>
            <ProtoInterface>
              <field name='on' type='SFBool' accessType='inputOnly'/>
            </ProtoInterface>
            <ProtoBody>
              <Transform DEF='Inner'/>
            </ProtoBody>
          </ProtoDeclare>
          <TimeSensor DEF='Clock'/>
          <OrientationInterpolator DEF='Turn'/>
          <Transform DEF='Wheel'/>
          <TouchSensor DEF='Touch'/>
          <ProtoInstance DEF='F' name='Fan'/>
          <Script DEF='S'><field name='in' type='SFTime' accessType='inputOnly'/></Script>
          <Inline DEF='Room' url='"room.x3d"'/>
          <IMPORT inlineDEF='Room' importedDEF='Lamp' AS='Light'/>
      %s  </Scene>
      </X3D>
      """;

  private final NodeCatalogue catalogue = NodeCatalogue.load();

  private static String route(String from, String to) {
    return "    <ROUTE fromNode='%s' fromField='%s' toNode='%s' toField='%s'/>\n"
        .formatted((Object[]) (from + "." + to).split("\\."));
  }

  private static SceneDocument document(String routes) throws IOException {
    return SceneDocument.of("a.x3d", SCENE.formatted(routes).getBytes(StandardCharsets.UTF_8));
  }

  private static DocumentElement node(SceneDocument document, String name) {
    return document.tree().orElseThrow().named(name).orElseThrow();
  }

  private EventField field(SceneDocument document, String node, String name) {
    return EventField.of(node(document, node), catalogue).stream()
        .filter(field -> field.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void routesAreCheckedForNodesFieldsDirectionAndType() throws IOException {
    SceneDocument document =
        document(
            route("Clock.fraction_changed", "Turn.set_fraction")
                + route("Turn.value_changed", "Wheel.set_rotation")
                + route("Turn.value_changed", "Wheel.translation")
                + route("Turn.set_fraction", "Wheel.rotation")
                + route("Turn.value_changed", "Wheel.colour")
                + route("Nobody.time", "S.in")
                + route("Clock.time", "Inner.x")
                + route("Touch.isActive", "F.on")
                + route("Touch.isActive", "Light.on")
                + route("Clock.time", "S.in")
                + route("Clock.time", "S.in")
                + "    <ROUTE fromNode='Clock'/>\n");
    List<SceneRoute> routes = SceneRoute.in(document, catalogue);
    assertThat(routes)
        .extracting(SceneRoute::fault)
        .containsExactly(
            Fault.NONE,
            Fault.NONE,
            Fault.TYPES,
            Fault.NOT_SENT,
            Fault.NOT_RECEIVED,
            Fault.NO_SOURCE,
            Fault.NO_TARGET,
            Fault.NONE,
            Fault.NONE,
            Fault.NONE,
            Fault.REPEATED,
            Fault.INCOMPLETE);
    assertThat(routes.get(1).type()).isEqualTo(Optional.of(FieldType.SFRotation));
  }

  @Test
  void aRouteIsAddedBehindTheNodesAndDeletedEachInOneStep() throws IOException {
    SceneDocument document = document("");
    String before = document.text().toString();
    RouteEdits edits = new RouteEdits(document);
    EventField from = field(document, "Turn", "value_changed");
    assertThat(RouteEdits.fit(from, field(document, "Wheel", "rotation"))).isTrue();
    assertThat(RouteEdits.fit(from, field(document, "Wheel", "translation"))).isFalse();
    assertThat(RouteEdits.fit(field(document, "Wheel", "rotation"), from)).isFalse();
    document.perform(
        edits.add(
            node(document, "Turn"),
            from,
            node(document, "Wheel"),
            field(document, "Wheel", "rotation")));
    String added = document.text().toString();
    assertThat(added).isEqualTo(SCENE.formatted(route("Turn.value_changed", "Wheel.rotation")));
    SceneRoute route = SceneRoute.in(document, catalogue).get(0);
    assertThat(route.fault()).isEqualTo(Fault.NONE);
    document.perform(edits.delete(route));
    assertThat(document.text().toString()).isEqualTo(before);
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(added);
  }

  @Test
  void aRouteDoesNotLeadIntoAPrototype() throws IOException {
    SceneDocument document = document("");
    DocumentElement[] inner = new DocumentElement[1];
    document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            element -> {
              if (element.def().filter("Inner"::equals).isPresent()) {
                inner[0] = element;
              }
            });
    EventField rotation = field(document, "Wheel", "rotation");
    assertThatThrownBy(
            () ->
                new RouteEdits(document).add(node(document, "Wheel"), rotation, inner[0], rotation))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("scope");
  }
}
