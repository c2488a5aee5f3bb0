package org.selectiverenderer.doctor.report;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.doctor.Diagnosis;

class DoctorReportTest {
  private static final Diagnosis JAVA = Diagnosis.ok("Java", "17");
  private static final Diagnosis SLOW = Diagnosis.warning("OpenGL", "llvmpipe", "get a driver");
  private static final Diagnosis SILENT = Diagnosis.missing("sound", "none", "");
  private static final Diagnosis BLIND = Diagnosis.lacking("display", "none", "connect one");

  private final DoctorReport well = new DoctorReport("1.2.3", List.of(JAVA, SLOW, SILENT));
  private final DoctorReport ill = new DoctorReport("1.2.3", List.of(JAVA, BLIND, BLIND));

  @Test
  void isALineForEachInColumns() {
    assertThat(well.text())
        .isEqualTo(
            """
            ok       Java    17
            warning  OpenGL  llvmpipe -> get a driver
            missing  sound   none
            """);
  }

  @Test
  void isHealthyWithoutWhatOnlySomeNeed() {
    assertThat(well.healthy()).isTrue();
    assertThat(well.summary())
        .isEqualTo("1 ok, 1 warning, 1 missing; nothing is missing that everybody needs");
    assertThat(ill.healthy()).isFalse();
    assertThat(ill.summary()).isEqualTo("1 ok, 0 warning, 2 missing; needed by everybody: display");
  }

  @Test
  void jsonFollowsThePublishedSchema() throws IOException {
    ObjectMapper mapper = new ObjectMapper();
    try (InputStream in =
        Objects.requireNonNull(DoctorReport.class.getResourceAsStream("doctor.schema.json"))) {
      JsonSchema schema =
          JsonSchemaFactory.getInstance(VersionFlag.V202012).getSchema(mapper.readTree(in));
      JsonNode report = mapper.readTree(ill.json());
      assertThat(schema.validate(report)).isEmpty();
      assertThat(schema.validate(mapper.readTree(well.json()))).isEmpty();
      assertThat(schema.validate(mapper.readTree("{\"checks\":[{}]}"))).isNotEmpty();
      assertThat(report.at("/checks/1/needed").asBoolean()).isTrue();
      assertThat(report.at("/summary/missing").asInt()).isEqualTo(2);
    }
  }

  @Test
  void aLineComesBackFromItsText() {
    assertThat(Diagnosis.read(BLIND.json().toString())).contains(BLIND);
    assertThat(Diagnosis.read("{\"status\":\"ok\",\"subj")).isEmpty();
    assertThat(Diagnosis.read("{\"status\":\"fine\"}")).isEmpty();
    assertThat(Diagnosis.ok("a", "b\nc \t d").found()).isEqualTo("b c d");
  }

  @Test
  void theFolderOfTheUserIsNotPublished() {
    assertThat(Diagnosis.ok("a", "/home/ada/.config").without("/home/ada").found())
        .isEqualTo("~/.config");
    assertThat(Diagnosis.ok("a", "/tmp/x").without("/").found()).isEqualTo("/tmp/x");
  }
}
