package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/**
 * Rooms in files of their own, inlined by one scene: schemas that one file names may occur only in
 * another.
 */
class InlinedRoomFilesTest {
  private static final String FILE =
      "<?xml version='1.0' encoding='UTF-8'?>\n"
          + "<X3D profile='Immersive' version='4.0'><Scene>%s</Scene></X3D>";
  private static final String AREA =
      "<ProximitySensor size='2 2 2'><MetadataString containerField='metadata'"
          + " name='enterTimeSchema' value='\"Desk\"'/></ProximitySensor>";
  private @TempDir Path dir;

  @BeforeEach
  void rooms() throws IOException {
    write("area.x3d", AREA);
    write(
        "object.x3d",
        "<Switch whichChoice='1'><MetadataSet containerField='metadata'><MetadataSet"
            + " containerField='value'><MetadataString containerField='value'"
            + " name='schemaBelonginess' value='\"Desk\"'/></MetadataSet></MetadataSet>"
            + "<Shape><Box/></Shape><Shape><Box/></Shape></Switch>");
  }

  private void write(String name, String nodes) throws IOException {
    Files.writeString(dir.resolve(name), FILE.formatted(nodes));
  }

  private static String inline(String file) {
    return "<Inline url='\"%s\"'/>".formatted(file);
  }

  private List<String> rules(String... files) throws IOException {
    List<SourceFile> sources = new ArrayList<>();
    for (String file : files) {
      sources.add(SourceFile.of(dir.resolve(file), dir));
    }
    return new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), dir)
        .validate(sources).findings().stream()
            .map(finding -> finding.location().file() + " " + finding.rule().id())
            .filter(finding -> finding.matches(".*SR40[56]"))
            .toList();
  }

  @Test
  void aRoomByItselfLacksWhatTheBuildingHas() throws IOException {
    assertThat(rules("area.x3d")).containsExactly("area.x3d SR405");
    assertThat(rules("object.x3d")).containsExactly("object.x3d SR406");
  }

  @Test
  void inTheBuildingNothingIsMissing() throws IOException {
    write("building.x3d", inline("area.x3d") + inline("object.x3d"));
    assertThat(rules("building.x3d")).isEmpty();
    assertThat(rules("area.x3d", "building.x3d", "object.x3d")).isEmpty();
  }

  @Test
  void ofScenesThatInlineEachOtherOneIsJudged() throws IOException {
    write("a.x3d", AREA + inline("b.x3d"));
    write("b.x3d", inline("a.x3d"));
    assertThat(rules("a.x3d", "b.x3d")).containsExactly("a.x3d SR405");
  }
}
