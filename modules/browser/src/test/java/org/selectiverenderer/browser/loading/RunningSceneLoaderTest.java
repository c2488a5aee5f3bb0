package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Files;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Inlines that are filled and emptied while the scene runs. */
class RunningSceneLoaderTest extends RunningSceneLoaderTestCase {
  @Test
  void anInlineThatIsNotLoadedAtFirstIsFilledWhenItIsTurnedOn() throws Exception {
    load("<Inline DEF='I' load='false' url='\"boxes2.x3d\"'/>");
    assertBoxes(0);
    set("I", "load", true);
    assertBoxes(0);
    arrive();
    assertBoxes(2);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void turnedOffItIsEmptyAtOnceAndTurnedOnAgainItIsBackAtOnce() throws Exception {
    load("<Inline DEF='I' url='\"boxes2.x3d\"'/>");
    assertBoxes(2);
    set("I", "load", false);
    assertBoxes(0);
    set("I", "load", true);
    assertBoxes(2);
    assertThat(arrivals).isEmpty();
  }

  @Test
  void theHierarchyOfALargeMeshComesWithItAndNoneForASmallOne() throws Exception {
    String heights = "0 ".repeat(150 * 150);
    String large =
        "<Shape><ElevationGrid xDimension='150' zDimension='150' height='%s'/></Shape>"
            .formatted(heights);
    write("large.x3d", large + "<Shape><Box/></Shape>");
    load("<Inline DEF='I' load='false' url='\"large.x3d\"'/>");
    set("I", "load", true);
    arrive();
    Mesh mesh = tree.shapes().get(0).mesh().orElseThrow();
    assertThat(built).containsOnlyKeys(mesh);
    assertThat(
            built
                .get(mesh)
                .nearest(
                    new Vector3d(70.3, 5, 70.2),
                    new Vector3d(0, -1, 0),
                    Double.POSITIVE_INFINITY,
                    MeshBvh.Sides.BOTH))
        .isPresent();
  }

  @Test
  void theOldContentStaysUntilTheNewIsThere() throws Exception {
    load("<Inline DEF='I' url='\"boxes2.x3d\"'/>");
    set("I", "url", url("boxes3.x3d"));
    assertBoxes(2);
    arrive();
    assertBoxes(3);
  }

  @Test
  void ofSeveralUrlsInARowTheLastCounts() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("boxes2.x3d"));
    set("I", "url", url("boxes3.x3d"));
    set("I", "url", url("boxes4.x3d"));
    arrive();
    arrive();
    arrive();
    assertBoxes(4);
  }

  @Test
  void whatArrivesAfterItWasTurnedOffIsNotShown() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("boxes2.x3d"));
    set("I", "load", false);
    arrive();
    assertBoxes(0);
    set("I", "load", true);
    arrive();
    assertBoxes(2);
  }

  @Test
  void whatCannotBeReadIsAProblemAndLeavesTheInlineEmpty() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("none.x3d"));
    assertThat(problems.list()).isEmpty();
    arrive();
    assertBoxes(0);
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly("test.x3d:2:1: Inline url 'none.x3d' is missing; the Inline is left out");
    set("I", "url", url("boxes2.x3d"));
    arrive();
    assertBoxes(2);
  }

  @Test
  void aRunningSceneMayNameNoMoreThanItsFileMight() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("../secret.x3d"));
    arrive();
    set("I", "url", url("http://example.org/a.x3d"));
    arrive();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "Inline url '../secret.x3d' points outside the folders this scene may name; --allow "
                + folder.getParent()
                + " would allow it; the Inline is left out",
            "Inline url 'http://example.org/a.x3d' is on the network; --allow-net example.org would"
                + " allow it; the Inline is left out");
  }

  @Test
  void anInlineCannotComeToIncludeItsOwnFile() throws Exception {
    write("outer.x3d", "<Inline DEF='Inner' url='\"boxes1.x3d\"'/>");
    load("<Inline DEF='I' url='\"outer.x3d\"'/>");
    InlineNode outer = (InlineNode) node("I");
    Node inner = outer.content().orElseThrow().find("Inner").orElseThrow();
    files.watch(List.of(outer, (InlineNode) inner));
    cascade.send(inner, inner.type().indexOf("url"), url("outer.x3d"));
    frame();
    arrive();
    assertBoxes(0);
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(folder.resolve("outer.x3d") + " includes itself; the Inline is left out");
  }

  @Test
  void lengthsAreConvertedBetweenTheUnitsOfTheFiles() throws Exception {
    Files.writeString(
        folder.resolve("centimetres.x3d"),
        "<X3D version='4.0'><head><unit category='length' name='cm' conversionFactor='0.01'/></head>"
            + "<Scene><Shape><Box/></Shape></Scene></X3D>");
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("centimetres.x3d"));
    arrive();
    assertThat(tree.shapes().get(0).world().m00()).isEqualTo(0.01);
  }

  @Test
  void anInlineMadeByAnApplicationIsFilledWhenItComesIntoTheScene() throws Exception {
    load("<Group DEF='G'/>");
    Node made =
        loader.factory().make(loader.catalogue().get("Inline"), null, SourceLocation.of("(made)"));
    made.init(made.type().indexOf("url"), url("boxes3.x3d"));
    set("G", "children", List.of(made));
    files.watch(List.of((InlineNode) made));
    frame();
    arrive();
    assertBoxes(3);
  }

  @Test
  void anInlineThatLeftTheSceneIsNoLongerFollowed() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    files.watch(List.of());
    set("I", "url", url("boxes2.x3d"));
    assertThat(arrivals).isEmpty();
  }

  @Test
  void anInlineThatLeavesWhileItIsReadIsFilledWhenItIsBack() throws Exception {
    load("<Inline DEF='I' load='false' url='\"boxes2.x3d\"'/>");
    set("I", "load", true);
    files.watch(List.of());
    arrive();
    assertBoxes(0);
    watch();
    frame();
    arrive();
    assertBoxes(2);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void anInlineWhoseUrlIsAnotherWhenItIsBackHasThatContent() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    files.watch(List.of());
    set("I", "url", url("boxes3.x3d"));
    watch();
    frame();
    assertBoxes(1);
    arrive();
    assertBoxes(3);
    files.watch(List.of());
    watch();
    frame();
    assertThat(arrivals).isEmpty();
  }

  @Test
  void theFirstProblemOfAnInlinedFileTellsWhichInlineNamesTheFile() throws Exception {
    Files.writeString(folder.resolve("broken.x3d"), "no scene");
    write("old.x3d", "<Foo/><Bar/>");
    load(
        """
        <Inline url='"broken.x3d"'/>
        <Group><Inline url='"old.x3d"'/></Group>
        <Inline DEF='I' load='false' url='"broken.x3d"'/>
        """);
    String nothing =
        "broken.x3d: this is neither XML nor VRML nor JSON: a scene begins with '<', '#X3D V',"
            + " '#VRML V' or '{'; nothing can be shown (the Inline at test.x3d:%s names this file)";
    assertThat(problems.list())
        .extracting(problem -> problem.toString().replace(folder + File.separator, ""))
        .containsExactly(
            nothing.formatted("2:1"),
            "old.x3d:2:1: unknown element Foo (did you mean Fog?); it and its children are left"
                + " out (the Inline at test.x3d:3:8 names this file)",
            "old.x3d:2:7: unknown element Bar; it and its children are left out");
  }
}
