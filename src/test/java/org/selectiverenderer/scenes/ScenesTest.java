package org.selectiverenderer.scenes;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.testing.X3dDocument;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

class ScenesTest {

  @ParameterizedTest
  @ValueSource(
      strings = {"hello", "trashcan", "overlap", "apartment", "apartment-plain", "practice"})
  void everyInlineAndEveryUseHasItsTarget(String name) throws IOException {
    check(Path.of("scenes", name + ".x3d"), new HashSet<>());
  }

  private static void check(Path file, Set<Path> seen) throws IOException {
    if (!seen.add(file.normalize())) {
      return;
    }
    X3dDocument document = X3dDocument.read(file);
    Set<String> defs = new HashSet<>();
    for (Element element : document.elements("*")) {
      String def = element.getAttribute("DEF");
      assertThat(def.isEmpty() || defs.add(def)).as("%s: DEF %s is unique", file, def).isTrue();
      String use = element.getAttribute("USE");
      assertThat(use.isEmpty() || defs.contains(use)).as("%s: USE %s", file, use).isTrue();
    }
    for (Element inline : document.elements("Inline")) {
      if (inline.hasAttribute("url")) {
        Path target = file.resolveSibling(inline.getAttribute("url").replace("\"", ""));
        assertThat(target).isRegularFile();
        check(target, seen);
      }
    }
  }

  /** Child i is described by MetadataSet i, low consistency by the version with more polygons. */
  @ParameterizedTest
  @ValueSource(strings = {"trashcan", "overlap"})
  void metadataSetsDescribeTheChildrenOfTheirSwitch(String name) throws IOException {
    X3dDocument document = X3dDocument.read(Path.of("scenes", name + ".x3d"));
    assertThat(document.elements("Switch")).isNotEmpty();
    for (Element node : document.elements("Switch")) {
      List<Element> children = childElements(node);
      List<Element> sets = childElements(children.remove(0));
      assertThat(sets).hasSameSizeAs(children);
      int shown = Integer.parseInt(node.getAttribute("whichChoice"));
      for (int i = 0; i < sets.size(); i++) {
        List<String> values =
            childElements(sets.get(i)).stream().map(e -> e.getAttribute("value")).toList();
        assertThat(values)
            .startsWith(
                i == shown
                    ? new String[] {"\"consistent\"", "\"high\"", "\"OfficeSchema\""}
                    : new String[] {"\"inconsistent\"", "\"low\""});
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"hello-orbit", "desk-visit", "overlap-visit", "apartment-tour"})
  void pathsRunForwardInTimeAndNeverTurnTheLongWayRound(String name) throws IOException {
    List<String> lines = Files.readAllLines(Path.of("scenes", "paths", name + ".csv"));
    assertThat(lines.get(0)).isEqualTo("t,x,y,z,yaw,pitch,roll");
    double[] last = null;
    for (String line : lines.subList(1, lines.size())) {
      double[] row = X3dDocument.numbers(line);
      assertThat(row).hasSize(7);
      if (last != null) {
        assertThat(row[0]).isGreaterThan(last[0]);
        assertThat(Math.abs(row[4] - last[4])).isLessThanOrEqualTo(180);
      }
      last = row;
    }
  }

  private static List<Element> childElements(Element parent) {
    List<Element> children = new ArrayList<>();
    for (Node n = parent.getFirstChild(); n != null; n = n.getNextSibling()) {
      if (n instanceof Element element) {
        children.add(element);
      }
    }
    return children;
  }
}
