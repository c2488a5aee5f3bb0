package org.selectiverenderer.browser.nodes.bindable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;

class BindingStacksTest {
  private final TestNodes nodes = new TestNodes();

  private Node viewpoint(String name) {
    return nodes.watch(nodes.named(name, "Viewpoint"), "isBound", "bindTime");
  }

  @Test
  void theFirstOfEachKindIsBoundAtTheStartWhateverASwitchShows() {
    Node first = viewpoint("first");
    Node second = viewpoint("second");
    Node fog = nodes.node("Fog");
    Node hidden = nodes.node("Switch", "children", List.of(first, fog));
    nodes.cascade.at(1);
    BindingStacks stacks = new BindingStacks(nodes.group(hidden, second), nodes.cascade);
    assertThat(nodes.sent()).containsExactly("first.isBound=true", "first.bindTime=1.0");
    assertThat(stacks.bound("X3DViewpointNode")).containsSame(first);
    assertThat(stacks.bound("Viewpoint")).containsSame(first);
    assertThat(stacks.bound("Fog")).containsSame(fog);
    assertThat(stacks.bound("NavigationInfo")).isEmpty();
    assertThat(stacks.bound("Background")).isEmpty();
    assertThat(stacks.all("Viewpoint")).containsExactly(first, second);
  }

  @Test
  void bindingTellsTheOldOneThenTheNewOneAtTheSameTime() {
    Node first = viewpoint("first");
    Node second = viewpoint("second");
    new BindingStacks(nodes.group(first, second), nodes.cascade);
    nodes.sent();
    nodes.cascade.at(2);
    nodes.send(second, "set_bind", true);
    assertThat(nodes.sent())
        .containsExactly(
            "first.isBound=false",
            "first.bindTime=2.0",
            "second.isBound=true",
            "second.bindTime=2.0");
    nodes.send(second, "set_bind", true);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void unbindingTheTopmostBindsTheNextBelow() {
    Node first = viewpoint("first");
    Node second = viewpoint("second");
    Node third = viewpoint("third");
    BindingStacks stacks = new BindingStacks(nodes.group(first, second, third), nodes.cascade);
    nodes.send(second, "set_bind", true);
    nodes.sent();
    nodes.send(second, "set_bind", false);
    assertThat(nodes.sent())
        .containsExactly(
            "second.isBound=false",
            "second.bindTime=0.0",
            "first.isBound=true",
            "first.bindTime=0.0");
    nodes.send(third, "set_bind", false);
    assertThat(nodes.sent()).isEmpty();
    nodes.send(first, "set_bind", false);
    assertThat(stacks.bound("Viewpoint")).isEmpty();
  }

  @Test
  void oneBelowTheTopmostLeavesTheStackSilently() {
    Node first = viewpoint("first");
    Node second = viewpoint("second");
    BindingStacks stacks = new BindingStacks(nodes.group(first, second), nodes.cascade);
    nodes.send(second, "set_bind", true);
    nodes.sent();
    nodes.send(first, "set_bind", false);
    assertThat(nodes.sent()).isEmpty();
    nodes.send(second, "set_bind", false);
    assertThat(stacks.bound("Viewpoint")).isEmpty();
  }

  @Test
  void aNodeStandsInItsStackOnce() {
    Node first = viewpoint("first");
    Node second = viewpoint("second");
    BindingStacks stacks = new BindingStacks(nodes.group(first, second), nodes.cascade);
    nodes.send(second, "set_bind", true);
    nodes.send(first, "set_bind", true);
    nodes.send(first, "set_bind", false);
    assertThat(stacks.bound("Viewpoint")).containsSame(second);
    nodes.send(second, "set_bind", false);
    assertThat(stacks.bound("Viewpoint")).isEmpty();
  }

  @Test
  void viewpointsOfBothKindsShareAStackAndOtherKindsHaveTheirOwn() {
    Node perspective = viewpoint("perspective");
    Node ortho = nodes.node("OrthoViewpoint");
    Node background = nodes.node("Background");
    Node texture = nodes.node("TextureBackground");
    BindingStacks stacks =
        new BindingStacks(nodes.group(ortho, perspective, background, texture), nodes.cascade);
    stacks.bind(texture, nodes.cascade);
    stacks.bind(perspective, nodes.cascade);
    assertThat(stacks.bound("Viewpoint")).containsSame(perspective);
    assertThat(stacks.bound("X3DBackgroundNode")).containsSame(texture);
    assertThat(ortho.bool("isBound")).isFalse();
  }

  @Test
  void aViewpointInAnInlineIsNotBoundAtTheStartButCanBe() {
    Node inner = viewpoint("inner");
    InlineNode inline = (InlineNode) nodes.node("Inline");
    inline.fill(new Scene(nodes.group(inner), "", "4.0", "Full", Map.of(), 1), 1);
    BindingStacks stacks = new BindingStacks(nodes.group(inline), nodes.cascade);
    assertThat(stacks.bound("Viewpoint")).isEmpty();
    nodes.send(inner, "set_bind", true);
    assertThat(stacks.bound("Viewpoint")).containsSame(inner);
  }

  @Test
  void theViewOfAWholeModelIsNotOfferedWhereAnInlineShowsTheModel() {
    Node overview = nodes.node("Viewpoint", "viewAll", true);
    Node named = nodes.node("Viewpoint", "viewAll", true, "description", "All");
    InlineNode inline = (InlineNode) nodes.node("Inline");
    inline.fill(new Scene(nodes.group(overview, named), "", "4.0", "Full", Map.of(), 1), 1);
    Node outside = nodes.node("Viewpoint", "viewAll", true);
    BindingStacks stacks = new BindingStacks(nodes.group(inline, outside), nodes.cascade);
    assertThat(stacks.all("Viewpoint")).containsExactly(named, outside);
    assertThat(stacks.bound("Viewpoint")).containsSame(outside);
  }

  @Test
  void aViewpointThatComesLaterCanBeBoundAndOneThatGoesIsUnbound() {
    Node first = viewpoint("first");
    Node later = viewpoint("later");
    Node inner = nodes.group();
    Node root = nodes.group(first, inner);
    BindingStacks stacks = new BindingStacks(root, nodes.cascade);
    nodes.send(inner, "addChildren", List.of(later));
    stacks.structureChanged();
    stacks.update(nodes.cascade);
    nodes.send(later, "set_bind", true);
    nodes.sent();
    nodes.send(root, "removeChildren", List.of(inner));
    nodes.cascade.at(9);
    stacks.structureChanged();
    stacks.update(nodes.cascade);
    assertThat(nodes.sent())
        .containsExactly(
            "later.isBound=false",
            "later.bindTime=9.0",
            "first.isBound=true",
            "first.bindTime=9.0");
    nodes.send(later, "set_bind", true);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void theNavigationInfoOfAViewpointIsBoundWithIt() {
    Node info = nodes.node("NavigationInfo");
    Node own = nodes.node("NavigationInfo", "speed", 3f);
    Node first = viewpoint("first");
    Node second = nodes.node("Viewpoint", "navigationInfo", own);
    BindingStacks stacks = new BindingStacks(nodes.group(first, second, info), nodes.cascade);
    stacks.bind(second, nodes.cascade);
    assertThat(stacks.bound("NavigationInfo")).containsSame(own);
    stacks.bind(first, nodes.cascade);
    assertThat(stacks.bound("NavigationInfo")).containsSame(info);
  }

  @Test
  void valuesAreReadInTheirOwnWords() {
    ViewpointNode viewpoint =
        (ViewpointNode)
            nodes.node("Viewpoint", "position", new float[] {1, 2, 3}, "orientation", new float[4]);
    assertThat(viewpoint.position().x).isEqualTo(1);
    assertThat(viewpoint.orientation().w).isEqualTo(1);
    assertThat(((ViewpointNode) nodes.node("OrthoViewpoint")).fieldOfView()).isEqualTo(Math.PI / 4);
  }

  @Test
  void anotherNameIsRefused() {
    BindingStacks stacks = new BindingStacks(nodes.group(), nodes.cascade);
    assertThatThrownBy(() -> stacks.bound("Shape")).hasMessageContaining("Shape");
  }
}
