package org.selectiverenderer.study.questionnaire.read;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.JsonSettingsReader;
import org.selectiverenderer.study.questionnaire.AudioFileName;
import org.selectiverenderer.study.questionnaire.BranchingRule;
import org.selectiverenderer.study.questionnaire.PictureFile;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.QuestionKind;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.SliderField;
import org.selectiverenderer.x3d.url.NetworkShare;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Reads the JSON file of a questionnaire, which {@code questionnaire.schema.json} describes. */
public final class QuestionnaireReader {
  private static final JsonSettingsReader JSON =
      new JsonSettingsReader("a questionnaire", "the questionnaire is not used");

  /** Pattern of names and ids, which occur in tables, journals and names of files. */
  private static final String NAME = "[0-9A-Za-z][0-9A-Za-z_-]*";

  /** Largest number of values that a message lists. */
  private static final int MOST_LISTED = 30;

  private final Optional<Path> folder;
  private final Predicate<Path> pictures;
  private final LocalizedTexts texts;
  private final Map<String, Question> questions = new LinkedHashMap<>();
  private final Set<String> pages = new HashSet<>();

  /** Ids in tables that are derived from the answers to other questions. */
  private final Set<String> columns = new HashSet<>();

  private QuestionnaireReader(
      Optional<Path> folder, Predicate<Path> pictures, LocalizedTexts texts) {
    this.folder = folder;
    this.pictures = pictures;
    this.texts = texts;
  }

  /**
   * Reads a file that may show the pictures of its own folder and project.
   *
   * @param language code of the language of the texts
   * @return empty if the file has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<Questionnaire> read(Path file, String language, ProblemCollector problems)
      throws IOException {
    UrlResolver own = new UrlResolver(file.toAbsolutePath().resolveSibling(""));
    return read(file, new LocalizedTexts(language), own::mayBeNamed, problems);
  }

  /**
   * Reads a file.
   *
   * @param texts the language of the texts, and all in which they are needed
   * @param pictures which pictures it may show
   * @return empty if the file has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<Questionnaire> read(
      Path file, LocalizedTexts texts, Predicate<Path> pictures, ProblemCollector problems)
      throws IOException {
    Optional<Path> folder = Optional.ofNullable(file.toAbsolutePath().getParent());
    try {
      return JSON.read(
          file, problems, new QuestionnaireReader(folder, pictures, texts)::questionnaire);
    } catch (UncheckedIOException e) {
      throw e.getCause(); // A picture could not be read.
    }
  }

  /**
   * Parses a text that is not a file in a folder, and so cannot refer to pictures.
   *
   * @param file name of the text, for messages
   */
  static Optional<Questionnaire> parse(
      String file, String text, String language, ProblemCollector problems) {
    return JSON.parse(
        file,
        text,
        problems,
        new QuestionnaireReader(Optional.empty(), picture -> false, new LocalizedTexts(language))
            ::questionnaire);
  }

  private Questionnaire questionnaire(JsonObjectReader keys) {
    String name = name(keys, "name", "a questionnaire's name");
    keys.text("source", false); // A citation of the questions' source, for people.
    String title = texts.optional(keys, "title");
    List<QuestionnairePage> read = keys.objects("pages", "a page", page -> page(page, title));
    if (read.isEmpty()) {
      keys.fault("pages", "a questionnaire needs \"pages\"");
    }
    return new Questionnaire(
        name, name, "", read, new ScoreDefinitionReader(questions).scores(keys));
  }

  private static String name(JsonObjectReader keys, String key, String what) {
    String name = keys.text(key);
    if (!name.isEmpty() && !name.matches(NAME)) {
      keys.fault(key, what + " must consist of letters, digits, hyphens and underscores");
    }
    return name;
  }

  private QuestionnairePage page(JsonObjectReader keys, String title) {
    String id =
        keys.has("name")
            ? name(keys, "name", "a page's name")
            : String.format(Locale.ROOT, "page-%d", pages.size() + 1);
    if (!pages.add(id)) {
      keys.fault("name", "the page " + id + " is defined twice");
    }
    String own = texts.optional(keys, "title");
    String text = texts.optional(keys, "text");
    Optional<Path> picture = picture(keys, "picture");
    Optional<Path> audio =
        Optional.of(texts.optional(keys, "audio"))
            .filter(file -> !file.isEmpty())
            .flatMap(file -> audio(keys, file));
    Optional<BranchingRule> when = when(keys);
    boolean shuffled =
        keys.choice("order", List.of(false, true), QuestionnaireReader::order, false);
    List<List<Question>> read = keys.objects("questions", "a question", this::question);
    if (read.isEmpty() && text.isEmpty() && picture.isEmpty()) {
      keys.fault("a page needs a \"text\", a \"picture\" or \"questions\"");
    }
    return new QuestionnairePage(
        id,
        own.isEmpty() ? title : own,
        text,
        picture,
        audio,
        read.stream().flatMap(List::stream).toList(),
        shuffled,
        when);
  }

  private static String order(boolean shuffled) {
    return shuffled ? "random" : "fixed";
  }

  /** Returns a reader of texts that also reads pictures. */
  private QuestionKind.Texts pictured() {
    return new QuestionKind.Texts() {
      @Override
      public String text(JsonObjectReader keys, String key) {
        return texts.text(keys, key);
      }

      @Override
      public String optional(JsonObjectReader keys, String key) {
        return texts.optional(keys, key);
      }

      @Override
      public List<String> list(JsonObjectReader keys, String key) {
        return texts.list(keys, key);
      }

      @Override
      public Optional<Path> picture(JsonObjectReader keys, String key) {
        return QuestionnaireReader.this.picture(keys, key);
      }
    };
  }

  private Optional<Path> picture(JsonObjectReader keys, String key) {
    return keys.text(key, false).flatMap(name -> named(keys, name));
  }

  private Optional<Path> named(JsonObjectReader keys, String name) {
    if (!name.toLowerCase(Locale.ROOT).matches(".*\\.(png|jpe?g)")) {
      keys.fault("picture", "a picture must be a PNG or JPEG file");
      return Optional.empty();
    }
    Optional<Path> file = own(keys, "picture", name);
    if (file.isPresent()) {
      fault(file.get())
          .ifPresent(fault -> keys.fault("picture", "the file '%s' %s".formatted(name, fault)));
    }
    return file;
  }

  private Optional<Path> audio(JsonObjectReader keys, String name) {
    if (!AudioFileName.known(name)) {
      keys.fault("audio", AudioFileName.NEEDED);
      return Optional.empty();
    }
    return own(keys, "audio", name);
  }

  /** Returns a file that the questionnaire may show or play; reports any other. */
  private Optional<Path> own(JsonObjectReader keys, String key, String name) {
    Optional<Path> file = folder.map(base -> base.resolve(name).normalize());
    if (NetworkShare.is(name) || file.filter(pictures).isEmpty() && folder.isPresent()) {
      keys.fault(
          key,
          "the %s '%s' is outside of the study; put it beside the questionnaire, or its folder into the study's \"allow\""
              .formatted(key, name));
      return Optional.empty();
    } else if (file.isEmpty() || !Files.isRegularFile(file.get())) {
      keys.fault(key, "there is no file '" + name + "' relative to the questionnaire's file");
      return Optional.empty();
    }
    return file;
  }

  private static Optional<String> fault(Path picture) {
    try {
      return PictureFile.fault(picture);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<Question> question(JsonObjectReader keys) {
    String id = name(keys, "id", "a question's id");
    Optional<BranchingRule> when = when(keys);
    String text = texts.optional(keys, "text");
    boolean optional = keys.truth("optional", false);
    boolean personal = keys.truth("personal", false);
    Optional<String> must = keys.text("must", false);
    Optional<Question.Sets> sets =
        keys.has("sets")
            ? Optional.of(
                keys.choice(
                    "sets",
                    List.of(Question.Sets.values()),
                    Question.Sets::spelling,
                    Question.Sets.AGE))
            : Optional.empty();
    Optional<QuestionKind> kind = QuestionKind.read(keys, pictured(), id, text);
    if (sets.equals(Optional.of(Question.Sets.IPD)) && kind.isPresent() && !isIpd(kind.get())) {
      keys.fault(
          "sets",
          ("an interpupillary distance is a \"number\" in millimetres; it needs \"min\" and "
                  + "\"max\" from 0 to %.0f")
              .formatted(EyeGeometry.LARGEST_IPD));
    }
    if (kind.isPresent() && must.isPresent()) {
      known(keys, "must", must.get(), kind.get());
    }
    if (kind.isEmpty()) {
      return List.of();
    }
    Map<String, String> rows = new LinkedHashMap<>();
    if (kind.get().grid().isEmpty()) {
      rows.put(id, text);
    } else {
      QuestionKind.rows(keys, texts).forEach((row, says) -> rows.put(id + "_" + row, says));
      if (must.isPresent() || sets.isPresent()) {
        keys.fault("a grid has several answers, so it can have neither \"must\" nor \"sets\"");
      }
    }
    List<Question> read = new ArrayList<>();
    rows.forEach(
        (row, says) -> {
          Question one = new Question(row, says, kind.get(), optional, when, must, sets, personal);
          if (questions.putIfAbsent(row, one) != null || columns.contains(row)) {
            keys.fault("id", "the question " + row + " is defined twice");
          }
          read.add(one);
        });
    for (String part : kind.get().parts()) {
      String column = id + "_" + part;
      if (!columns.add(column) || questions.containsKey(column)) {
        keys.fault("id", "the question " + column + " is defined twice");
      }
    }
    return read;
  }

  /** Reports a value that no answer can have. */
  private static void known(JsonObjectReader keys, String key, String value, QuestionKind kind) {
    List<String> values = kind.values();
    if (!values.isEmpty() && !values.contains(value)) {
      keys.fault(
          key,
          "'%s' is not a possible answer; possible are %s"
              .formatted(
                  value,
                  values.size() > MOST_LISTED
                      ? kind.scale().map(SliderField::allowed).orElse(values.get(0) + ", ...")
                      : String.join(", ", values)));
    }
  }

  /** Returns whether every valid answer is a possible interpupillary distance. */
  private static boolean isIpd(QuestionKind kind) {
    return kind.numbers()
        .filter(range -> range.least() >= 0 && range.most() <= EyeGeometry.LARGEST_IPD)
        .isPresent();
  }

  /** Reads a branching rule, which may refer to earlier questions only. */
  private Optional<BranchingRule> when(JsonObjectReader keys) {
    Set<String> earlier = Set.copyOf(questions.keySet());
    return keys.object(
        "when",
        "a condition",
        condition -> {
          String question = condition.text("question");
          if (!question.isEmpty() && !earlier.contains(question)) {
            condition.fault(
                "question",
                "there is no earlier question '%s'%s"
                    .formatted(
                        question,
                        SpellingSuggester.nearest(question, earlier)
                            .map(near -> "; did you mean '%s'?".formatted(near))
                            .orElse("")));
          }
          List<String> is = new ArrayList<>(condition.texts("is"));
          if (is.isEmpty()) {
            condition.fault("is", "a condition needs the values that the answer \"is\" one of");
          }
          Question asked = questions.get(question);
          if (asked != null) {
            is.forEach(value -> known(condition, "is", value, asked.kind()));
          }
          return new BranchingRule(question, Set.copyOf(is));
        });
  }
}
