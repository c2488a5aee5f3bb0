package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.design.TrialPhase;

/** A study in several languages, of which each participant has one. */
class StudyLanguagesTest {
  private static final String ITEMS = "area,object,consistency,present,en,el\n";

  @TempDir Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  @BeforeEach
  void write() throws IOException {
    Files.writeString(
        folder.resolve("mood.json"),
        """
        {"name": "mood", "pages": [{"title": {"en": "Mood", "el": "Διάθεση"}, "questions": [
          {"id": "calm", "kind": "scale", "from": 1, "to": 3,
           "text": {"en": "How calm are you?", "el": "Πόσο ήρεμος είστε;"},
           "steps": {"en": ["no", "so so", "yes"], "el": ["όχι", "έτσι κι έτσι", "ναι"]}}]}]}
        """);
    Files.writeString(folder.resolve("items.csv"), ITEMS + "hall,coat,consistent,yes,Coat,Παλτό\n");
  }

  private Path study(String languages, String instruction) throws IOException {
    Path file = folder.resolve("study.json");
    Files.writeString(
        file,
        """
        {"name": "Two", "conditions": ["high"], "participants": 4, %s, "item_areas": ["hall"],
         "blocks": [{"name": "b", "trial": [{"show": "instruction", "text": %s}]}],
         "questionnaires": [{"file": "mood.json"}, {"kind": "recognition", "items": "items.csv"},
           {"template": "sus"}]}
        """
            .formatted(languages, instruction));
    return file;
  }

  private Path study() throws IOException {
    return study("\"languages\": [\"en\", \"el\"]", "{\"en\": \"Look.\", \"el\": \"Κοιτάξτε.\"}");
  }

  private LoadedStudy in(String language) throws IOException {
    return LoadedStudy.read(study(), Optional.of(language), study -> true, problems).orElseThrow();
  }

  private static String instruction(LoadedStudy study) {
    return ((TrialPhase.Instruction) study.study().design().blocks().get(0).phases().get(0)).text();
  }

  private static List<String> texts(LoadedStudy study) {
    return study.questionnaires("001").stream()
        .flatMap(each -> each.pages().stream())
        .map(page -> page.questions().get(0).text())
        .toList();
  }

  private List<String> faults(Path file) throws IOException {
    ProblemCollector found = new ProblemCollector();
    assertThat(LoadedStudy.read(file, found)).isEmpty();
    return found.list().stream().map(Problem::toString).toList();
  }

  @Test
  void allTextsAreInTheChosenLanguageAndTheFirstIsTheDefault() throws IOException {
    LoadedStudy english = LoadedStudy.read(study(), problems).orElseThrow();
    assertThat(instruction(english)).isEqualTo("Look.");
    assertThat(texts(english)).startsWith("How calm are you?", "Coat");
    assertThat(english.wording().of("next")).isEqualTo("Continue");
    LoadedStudy greek = in("el");
    assertThat(instruction(greek)).isEqualTo("Κοιτάξτε.");
    assertThat(texts(greek)).startsWith("Πόσο ήρεμος είστε;", "Παλτό");
    assertThat(greek.wording().of("yes")).isEqualTo("Ναι");
    assertThat(greek.form().pages().get(0).questions().get(0).text())
        .isNotEqualTo(english.form().pages().get(0).questions().get(0).text());
    assertThat(greek.study().languages()).containsExactly("en", "el");
    assertThat(
            LoadedStudy.readAll(study(), Optional.of("el"), study -> true, problems).orElseThrow())
        .extracting(one -> one.study().language())
        .containsExactly("el", "en");
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aTextThatLacksALanguageIsAFaultWithItsPlace() throws IOException {
    assertThat(faults(study("\"languages\": [\"en\", \"el\"]", "{\"en\": \"Look.\"}")))
        .singleElement()
        .asString()
        .contains("study.json:2:", "\"text\" has no text in the study's language 'el', only in en");
    Files.writeString(folder.resolve("items.csv"), ITEMS + "hall,coat,consistent,yes,Coat,\n");
    assertThat(faults(study()))
        .singleElement()
        .asString()
        .contains("items.csv:2:", "the el is missing");
  }

  @Test
  void aFaultInTheSecondLanguageAloneIsFound() throws IOException {
    Path mood = folder.resolve("mood.json");
    Files.writeString(mood, Files.readString(mood).replace("\"έτσι κι έτσι\", ", ""));
    assertThat(faults(study())).singleElement().asString().contains("mood.json:4:");
    Files.writeString(mood, Files.readString(mood).replace("\"el\": \"Διάθεση\"", "\"de\": \"x\""));
    assertThat(faults(study())).hasSize(2).first().asString().contains("mood.json:1:");
  }

  @Test
  void aBuiltInScaleThatIsNotTranslatedIsAFault() throws IOException {
    Files.writeString(folder.resolve("messages_de.properties"), "yes = Ja\n");
    assertThat(faults(study("\"languages\": [\"en\", \"de\"]", "\"1\"")).toString())
        .contains("the built-in questionnaire sus has no texts in the language 'de'");
  }

  @Test
  void theKeysAreChecked() throws IOException {
    assertThat(faults(study("\"languages\": [], \"name2\": 1", "\"a\"")).toString())
        .contains("at least one language");
    assertThat(faults(study("\"languages\": [\"en\", \"en\"]", "\"a\"")).toString())
        .contains("the language en is listed twice");
    assertThat(faults(study("\"languages\": [\"../x\"]", "\"a\"")).toString())
        .contains("a language is a code such as \"en\" or \"el\"");
    assertThat(faults(study("\"language\": \"en\", \"languages\": [\"en\"]", "\"a\"")).toString())
        .contains("either \"language\" or \"languages\"");
    ProblemCollector found = new ProblemCollector();
    assertThat(LoadedStudy.read(study(), Optional.of("fr"), study -> true, found)).isEmpty();
    assertThat(found.list().toString())
        .contains("study.json:1:", "the study has no language 'fr', only en, el");
  }

  private static final SessionOptions OPTIONS =
      new SessionOptions(Optional.empty(), OptionalDouble.empty(), true, "test");

  @Test
  void aSessionKeepsItsLanguage() throws IOException {
    Session.begin(in("el"), "001", 1, OPTIONS, problems).close();
    assertThat(ParticipantLanguage.of(in("en").study(), "001", 1)).contains("el");
    assertThat(ParticipantLanguage.of(in("en").study(), "001", 2)).contains("el");
    assertThat(ParticipantLanguage.of(in("en").study(), "002", 1)).isEmpty();
    assertThatThrownBy(() -> Session.resume(in("en"), "001", 1, OPTIONS, problems))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("began in the language 'el', not in 'en'");
    Session.resume(in("el"), "001", 1, OPTIONS, problems).close();
    assertThat(Files.readString(folder.resolve("sub-001/ses-01/settings.json")))
        .contains("\"language\" : \"el\"");
  }
}
