# Repeats the analyses of a study's trials: analyses of variance by afex, mixed models by lme4 and lmerTest.
# Run it in this folder:  Rscript FILE.R [RESULTS.csv]
# Needs the package afex, for mixed models lme4 and lmerTest
# (install.packages(c("afex", "lme4", "lmerTest")), or on Debian r-cran-afex and r-cran-lmertest).

data_file <- @DATA@
analyses <- list(
@ANALYSES@
)

arguments <- commandArgs(TRUE)
here <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
if (length(here) == 1 && !file.exists(data_file)) data_file <- file.path(dirname(here), data_file)
if (!file.exists(data_file)) stop("there is no file ", data_file, "; run this script in its folder", call. = FALSE)

mixed <- any(vapply(analyses, function(a) a$mixed, NA))
needed <- c("afex", if (mixed) c("lme4", "lmerTest"))
lacking <- needed[!vapply(needed, requireNamespace, NA, quietly = TRUE)]
if (length(lacking)) {
  message("R lacks the package ", paste(lacking, collapse = ", "), "; install it with install.packages")
  quit(status = 3)
}
options(contrasts = c("contr.sum", "contr.poly"))
rows <- read.csv(data_file, colClasses = "character", encoding = "UTF-8", na.strings = character())

results <- NULL
keep <- function(analysis, model, effect, df1, df2, statistic, value, p, ges) {
  results <<- rbind(results, data.frame(analysis, model, effect, df1, df2, statistic, value, p, ges))
}
quietly <- function(x) suppressMessages(suppressWarnings(x))

variance <- function(i, d, a, f) {
  d <- aggregate(d["value"], d[c("participant", f)], if (a$median) median else mean)
  b <- f[a$between]
  w <- f[!a$between]
  t <- quietly(afex::aov_ez("participant", "value", d, between = if (length(b)) b, within = if (length(w)) w,
    anova_table = list(correction = "none", es = "ges")))$anova_table
  for (e in rownames(t))
    keep(i, "anova", e, t[e, "num Df"], t[e, "den Df"], "F", t[e, "F"], t[e, "Pr(>F)"], t[e, "ges"])
}

# The random slopes of all within factors where they can be estimated, else the intercepts of participants.
single <- function(i, d, a, f) {
  fixed <- paste("value ~", paste(f, collapse = " * "))
  w <- f[!a$between]
  forms <- c(if (length(w)) paste0(fixed, " + (1 + ", paste(w, collapse = " * "), " | participant)"),
    paste(fixed, "+ (1 | participant)"))
  best <- NULL
  for (form in forms) {
    warned <- FALSE
    fit <- tryCatch(withCallingHandlers(
      if (a$binary) lme4::glmer(as.formula(form), d, family = binomial,
        control = lme4::glmerControl(optimizer = "bobyqa", optCtrl = list(maxfun = 1e5)))
      else lmerTest::lmer(as.formula(form), d),
      warning = function(w) { warned <<- TRUE; invokeRestart("muffleWarning") },
      message = function(m) invokeRestart("muffleMessage")), error = function(e) NULL)
    if (is.null(fit)) next
    worse <- if (warned) 2 else if (lme4::isSingular(fit)) 1 else 0
    if (is.null(best) || worse <= best$worse) best <- list(fit = fit, form = form, worse = worse)
    if (worse == 0) break
  }
  if (is.null(best)) stop("the mixed model has no fit")
  fit <- best$fit
  model <- paste0(if (a$binary) "logistic mixed model, " else "linear mixed model, ",
    sub(".* \\+ \\(", "(", best$form), c("", ", singular", ", did not converge")[best$worse + 1])
  if (a$binary) {
    t <- quietly(car::Anova(fit, type = 3))
    for (e in setdiff(rownames(t), "(Intercept)"))
      keep(i, model, e, t[e, "Df"], NA, "chi2", t[e, "Chisq"], t[e, "Pr(>Chisq)"], NA)
  } else {
    t <- quietly(anova(fit, type = 3, ddf = "Satterthwaite"))
    for (e in rownames(t))
      keep(i, model, e, t[e, "NumDF"], t[e, "DenDF"], "F", t[e, "F value"], t[e, "Pr(>F)"], NA)
  }
}

for (i in seq_along(analyses)) {
  a <- analyses[[i]]
  d <- rows[rows$analysis == as.character(i), ]
  d$value <- as.numeric(d$value)
  f <- paste0("f", seq_along(a$labels))
  for (name in c("participant", f)) d[[name]] <- factor(d[[name]])
  tryCatch(variance(i, d, a, f), error = function(e)
    keep(i, "anova", "", NA, NA, paste("not computed:", conditionMessage(e)), NA, NA, NA))
  if (a$mixed) tryCatch(single(i, d, a, f), error = function(e)
    keep(i, "mixed model", "", NA, NA, paste("not computed:", conditionMessage(e)), NA, NA, NA))
  shown <- results[results$analysis == i, ]
  shown$effect <- vapply(strsplit(shown$effect, ":", fixed = TRUE), function(parts) {
    at <- match(parts, f)
    paste(ifelse(is.na(at), parts, a$labels[at]), collapse = ":")
  }, "")
  cat("\n", a$name, "\n", sep = "")
  print(shown[-1], row.names = FALSE, digits = 5)
}
if (length(arguments)) write.csv(results, arguments[1], row.names = FALSE, na = "")
