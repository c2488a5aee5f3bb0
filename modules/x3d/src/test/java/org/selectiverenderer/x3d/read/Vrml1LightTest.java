package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.document;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.lines;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Lights of VRML 1.0, each of which illuminates what follows it in its group. */
class Vrml1LightTest {
  private final ReaderFixture fixture = new ReaderFixture();

  /** Returns where the lights are that illuminate each shape, in the order of the shapes. */
  private static List<List<String>> lightsOfShapes(String content) {
    List<List<String>> shapes = new ArrayList<>();
    Map<String, DocumentElement> named = new HashMap<>();
    Map<DocumentElement, String> places = new IdentityHashMap<>();
    for (DocumentElement element : document(content).elements()) {
      element.text("DEF").ifPresent(name -> named.put(name, element));
      if (element.name().equals("Shape")) {
        List<String> lights = new ArrayList<>();
        for (var at = element.parent(); at.isPresent(); at = at.get().parent()) {
          for (DocumentElement child : at.get().children()) {
            if (child.name().endsWith("Light")) {
              lights.add(places.computeIfAbsent(child, light -> place(light, named)));
            }
          }
        }
        lights.sort(null);
        shapes.add(lights);
      }
    }
    return shapes;
  }

  /** Returns the location of a light within the scene, in whole metres. */
  private static String place(DocumentElement element, Map<String, DocumentElement> named) {
    DocumentElement light = element.text("USE").map(named::get).orElse(element);
    Vector3d place = vector(light, "location");
    for (var at = element.parent(); at.isPresent(); at = at.get().parent()) {
      place.mul(at.get().text("scale").isPresent() ? vector(at.get(), "scale") : new Vector3d(1));
      place.add(vector(at.get(), "translation"));
    }
    return "%05d %05d %05d"
        .formatted(Math.round(place.x), Math.round(place.y), Math.round(place.z));
  }

  private static Vector3d vector(DocumentElement element, String field) {
    String[] numbers = element.text(field).orElse("0 0 0").split(" ");
    return new Vector3d(
        Double.parseDouble(numbers[0]),
        Double.parseDouble(numbers[1]),
        Double.parseDouble(numbers[2]));
  }

  private static int depth(String content) {
    int deepest = 0;
    for (DocumentElement element : document(content).elements()) {
      int depth = 1;
      for (var at = element.parent(); at.isPresent(); at = at.get().parent()) {
        depth++;
      }
      deepest = Math.max(deepest, depth);
    }
    return deepest;
  }

  @Test
  void aLightShinesOnWhatFollowsOnly() {
    assertThat(
            lines(
                """
                Separator {
                  Cube {}
                  Translation { translation 1 0 0 }
                  PointLight { location 0 5 0 intensity 0.5 }
                  Sphere {}
                }
                DirectionalLight { direction 0 -1 0 on FALSE }
                """))
        .containsExactly(
            "Group",
            " Shape",
            "  Appearance",
            "   Material",
            "  Box",
            " Transform translation=1 0 0",
            "  PointLight location=0 5 0 intensity=0.5 global=false radius=1000000",
            "  Shape",
            "   Appearance",
            "    Material",
            "   Sphere",
            "Group",
            " DirectionalLight direction=0 -1 0 on=false");
  }

  @Test
  void aLightDoesNotShineOnAMovedShapeBeforeIt() {
    assertThat(
            lightsOfShapes(
                "Separator { Cube {} Translation { translation 1 0 0 } Sphere {}"
                    + " PointLight { location 0 5 0 } Cone {} }"))
        .containsExactly(List.of(), List.of(), List.of("00001 00005 00000"));
  }

  @Test
  void aSpotLightKeepsItsCone() {
    assertThat(lines("SpotLight { location 0 1 0 cutOffAngle 0.6 }"))
        .containsExactly(
            "SpotLight location=0 1 0 cutOffAngle=0.6 beamWidth=0.6 global=false radius=1000000");
  }

  @Test
  void aLightWithoutALocationIsAMetreBeforeTheOrigin() {
    assertThat(lines("PointLight {} SpotLight { cutOffAngle 0.6 }"))
        .containsExactly(
            "PointLight location=0 0 1 global=false radius=1000000",
            "SpotLight location=0 0 1 cutOffAngle=0.6 beamWidth=0.6 global=false radius=1000000");
  }

  @Test
  void aThousandLightsBetweenShapesShineOnAllThatFollows() {
    StringBuilder text = new StringBuilder("Separator { Cube {} ");
    List<List<String>> expected = new ArrayList<>();
    List<String> lights = new ArrayList<>();
    expected.add(List.of());
    for (int i = 0; i < 1000; i++) {
      text.append("PointLight { location 0 %d 0 } Sphere {}\n".formatted(i));
      lights.add("00000 %05d 00000".formatted(i));
      expected.add(List.copyOf(lights));
    }
    String content = text.append("} Cone {}").toString();
    expected.add(List.of());
    assertThat(lightsOfShapes(content)).isEqualTo(expected);
    assertThat(depth(content)).isLessThan(50);
    assertThat(document(content).elements()).hasSizeLessThan(9_000);
    assertThat(scene(fixture, content).nodes()).hasSize(2);
    fixture.assertClean();
  }

  @Test
  void lightsThatMoveOnShineFromWhereTheyWere() {
    StringBuilder text = new StringBuilder("Separator { ");
    List<List<String>> expected = new ArrayList<>();
    List<String> lights = new ArrayList<>();
    for (int i = 1; i <= 300; i++) {
      text.append("Translation { translation 1 0 0 } ");
      text.append("PointLight { location 0 %d 0 } PointLight {} Sphere {}\n".formatted(i));
      lights.add("%05d %05d 00000".formatted(i, i));
      lights.add("%05d 00000 00001".formatted(i));
      List<String> now = new ArrayList<>(lights);
      now.sort(null);
      expected.add(now);
    }
    String content = text.append("}").toString();
    assertThat(lightsOfShapes(content)).isEqualTo(expected);
    assertThat(depth(content)).isLessThan(50);
    scene(fixture, content);
    fixture.assertClean();
  }

  @Test
  void lightsBesideTheFirstOneOfAGroupAreNotDoubled() {
    StringBuilder text = new StringBuilder("Separator { PointLight { location 7 0 0 } ");
    List<List<String>> expected = new ArrayList<>();
    List<String> lights = new ArrayList<>(List.of("00007 00000 00000"));
    for (int i = 0; i < 100; i++) {
      text.append("Sphere {} DEF L%d PointLight { location 0 %d 0 }\n".formatted(i, i));
      expected.add(List.copyOf(lights));
      lights.add(lights.size() - 1, "00000 %05d 00000".formatted(i));
    }
    assertThat(lightsOfShapes(text.append("}").toString())).isEqualTo(expected);
  }

  @Test
  void aLightThatIsUsedManyTimesShinesFromEachOfItsPlaces() {
    StringBuilder text = new StringBuilder("DEF L PointLight { location 0 0 3 } Separator { ");
    List<List<String>> expected = new ArrayList<>();
    List<String> lights = new ArrayList<>(List.of("00000 00000 00003"));
    for (int i = 1; i <= 60; i++) {
      text.append("Translation { translation 0 2 0 } USE L Cube {}\n");
      lights.add("00000 %05d 00003".formatted(2 * i));
      expected.add(List.copyOf(lights));
    }
    assertThat(lightsOfShapes(text.append("}").toString())).isEqualTo(expected);
  }

  @Test
  void aRepeatedLightShinesInItsDirectionThroughRotations() {
    assertThat(
            lines(
                "Separator { Cube {} Rotation { rotation 0 0 1 1.5707963 }"
                    + " SpotLight { location 3 0 0 direction 1 0 0 } "
                    + "Cube {} PointLight {} ".repeat(8)
                    + "Sphere {} }"))
        .anyMatch(line -> line.matches(" {2}SpotLight location=\\S+ 3 0 direction=\\S+ 1 0 .*"));
  }
}
