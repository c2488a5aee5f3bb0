# Makes anova-data.csv.gz and anova-golden.csv.gz; see README.md beside this file.
suppressMessages({library(afex); library(car); library(emmeans); library(BayesFactor)})
folder <- commandArgs(trailingOnly = TRUE)[1]
set.seed(20090401)
emm_options(lmer.df = "asymptotic")
BOUND <- 0.5      # of TOST, in the measure's own units
ETA <- 0.06       # of the equivalence of effects
data_lines <- c("set,subject,group,level,value")
lines <- c("set,key,value")

put <- function(set, key, value) {
  if (length(value) == 1 && is.finite(value))
    lines[length(lines) + 1] <<- sprintf("%d,%s,%.15g", set, key, value)
}

eta_interval <- function(f, df1, df2) {
  bound <- function(p) {
    if (pf(f, df1, df2) <= p) return(0)
    top <- 10; while (pf(f, df1, df2, top) > p) top <- top * 2
    uniroot(function(l) pf(f, df1, df2, l) - p, c(0, top), tol = 1e-12)$root
  }
  l <- c(bound(0.95), bound(0.05)); l / (l + df1 + df2 + 1)
}

# R's and car's own second-order term has 3 * levels where Anderson (2003, 10.7.4) has 3 * contrasts.
mauchly_p <- function(w, q, n) {
  rho <- 1 - (2 * q^2 + q + 2) / (6 * q * n)
  w2 <- (q + 2) * (q - 1) * (q - 2) * (2 * q^3 + 6 * q^2 + 3 * q + 2) / (288 * (n * q * rho)^2)
  z <- -n * rho * log(w); f <- q * (q + 1) / 2 - 1
  first <- pchisq(z, f, lower.tail = FALSE)
  min(1, first + w2 * (pchisq(z, f + 4, lower.tail = FALSE) - first))
}

effect <- function(set, name, ss, sse, df1, df2, ges = NA) {
  f <- (ss / df1) / (sse / df2)
  key <- function(what) paste("effect", name, what, sep = "|")
  put(set, key("ss"), ss); put(set, key("error"), sse)
  put(set, key("df1"), df1); put(set, key("df2"), df2)
  put(set, key("F"), f); put(set, key("p"), pf(f, df1, df2, lower.tail = FALSE))
  put(set, key("pes"), ss / (ss + sse)); put(set, key("ges"), ges)
  if (name != "intercept") {
    ci <- eta_interval(f, df1, df2)
    put(set, key("low"), ci[1]); put(set, key("high"), ci[2])
  }
  put(set, key("equivalence"), pf(f, df1, df2, ETA / (1 - ETA) * (df1 + df2 + 1)))
}

multivariate <- function(set, name, test, df.error) {
  eig <- Re(eigen(solve(test$SSPE, test$SSPH), symmetric = FALSE)$values)
  for (s in c("Pillai", "Wilks", "HL", "Roy")) {
    r <- getFromNamespace(s, "stats")(eig, test$df, df.error)
    key <- function(what) paste(s, name, what, sep = "|")
    put(set, key("value"), r[1]); put(set, key("F"), r[2])
    put(set, key("df1"), r[3]); put(set, key("df2"), r[4])
    if (r[4] > 0) put(set, key("p"), pf(r[2], r[3], r[4], lower.tail = FALSE))
  }
}

label <- function(x) if (length(x) == 0 || is.null(x)) "" else as.character(x)

means <- function(set, grid) {
  table <- as.data.frame(summary(grid, infer = c(TRUE, FALSE)))
  for (i in seq_len(nrow(table))) {
    row <- table[i, ]
    key <- function(what) paste("mean", label(row$group), label(row$level), what, sep = "|")
    put(set, key("mean"), row$emmean); put(set, key("se"), row$SE)
    put(set, key("low"), row$lower.CL); put(set, key("high"), row$upper.CL)
  }
}

pairs_of <- function(set, factor, grid, by = NULL) {
  p <- pairs(grid, adjust = "none")
  raw <- as.data.frame(summary(p, infer = c(TRUE, TRUE), by = by))
  holm <- as.data.frame(summary(p, adjust = "holm", by = by))
  tost <- as.data.frame(test(p, delta = BOUND, side = "equivalence", adjust = "none", by = by))
  for (i in seq_len(nrow(raw))) {
    at <- if (is.null(by)) "" else as.character(raw[[by]][i])
    key <- function(what) paste("pair", factor, at, gsub(" - ", "|", raw$contrast[i]), what, sep = "|")
    put(set, key("difference"), raw$estimate[i]); put(set, key("se"), raw$SE[i])
    put(set, key("low"), raw$lower.CL[i]); put(set, key("high"), raw$upper.CL[i])
    put(set, key("t"), raw$t.ratio[i]); put(set, key("p"), raw$p.value[i])
    put(set, key("holm"), holm$p.value[i]); put(set, key("tost"), tost$p.value[i])
  }
}

for (set in 1:200) {
  kind <- c("mixed", "mixed", "mixed", "oneway", "repeated")[(set - 1) %% 5 + 1]
  g <- if (kind == "repeated") 1 else sample(2:4, 1)
  k <- if (kind == "oneway") 1 else sample(2:4, 1)
  n <- if (set %% 2 == 0) rep(sample(4:16, 1), g) else sample(3:20, g, replace = TRUE)
  if (sum(n) < g + k + 3) n[1] <- n[1] + k + 4
  covariance <- crossprod(matrix(rnorm(k * k), k)) + diag(k) * 0.3
  shift <- matrix(rnorm(g * k, 0, sample(c(0, 0.5, 2), 1)), g)
  d <- do.call(rbind, lapply(1:g, function(j) {
    y <- matrix(rnorm(n[j] * k), n[j]) %*% chol(covariance)
    y <- round(sweep(y, 2, shift[j, ], "+"), 3)
    data.frame(subject = rep(paste0("s", j, "-", 1:n[j]), k), group = paste0("g", j),
               level = rep(paste0("l", 1:k), each = n[j]), value = as.vector(y))
  }))
  data_lines <- c(data_lines, sprintf("%d,%s,%s,%s,%.15g", set, d$subject, d$group, d$level, d$value))
  for (column in c("subject", "group", "level")) d[[column]] <- factor(d[[column]], levels = unique(d[[column]]))
  formula <- switch(kind,
    mixed = value ~ group + Error(subject / level),
    oneway = value ~ group + Error(subject),
    repeated = value ~ Error(subject / level))
  fit <- suppressMessages(suppressWarnings(aov_car(formula, d, type = 3, include_aov = FALSE)))
  ges <- anova(fit, es = "ges", correction = "none", intercept = TRUE)
  ges_of <- function(name) if (name %in% rownames(ges)) ges[name, "ges"] else NA
  named <- c("(Intercept)" = "intercept", group = "group", level = "level", "group:level" = "level x group")
  if (kind == "oneway") {
    table <- fit$Anova; sse <- table["Residuals", "Sum Sq"]; df2 <- table["Residuals", "Df"]
    for (e in c("(Intercept)", "group")) effect(set, named[[e]], table[e, "Sum Sq"], sse, table[e, "Df"], df2, ges_of(e))
  } else {
    s <- summary(fit$Anova, multivariate = TRUE)
    u <- s$univariate.tests
    for (e in rownames(u)) effect(set, named[[e]], u[e, "Sum Sq"], u[e, "Error SS"], u[e, "num Df"], u[e, "den Df"], ges_of(e))
    if (k > 2) {
      a <- s$pval.adjustments; m <- s$sphericity.tests
      for (e in rownames(a)) {
        key <- function(what) paste("sphericity", named[[e]], what, sep = "|")
        put(set, key("gg"), a[e, "GG eps"]); put(set, key("hf"), min(1, a[e, "HF eps"]))
        put(set, key("gg p"), a[e, "Pr(>F[GG])"]); put(set, key("hf p"), a[e, "Pr(>F[HF])"])
        put(set, key("W"), m[e, "Test statistic"])
        put(set, key("W p"), mauchly_p(m[e, "Test statistic"], k - 1, fit$Anova$error.df))
      }
    }
    for (e in setdiff(rownames(u), c("(Intercept)", "group")))
      multivariate(set, named[[e]], s$multivariate.tests[[e]], fit$Anova$error.df)
  }
  df <- sum(n) - g
  emm <- function(spec) suppressMessages(emmeans(fit, spec, model = "multivariate"))
  if (g > 1) { means(set, emm(~group)); pairs_of(set, "group", emm(~group)) }
  if (k > 1) { means(set, emm(~level)); pairs_of(set, "level", emm(~level)) }
  if (g > 1 && k > 1) {
    means(set, emm(~ group * level))
    pairs_of(set, "group", emm(~ group | level), "level")
    pairs_of(set, "level", emm(~ level | group), "group")
  }
  if (kind == "oneway" && g == 2) {
    test <- t.test(value ~ group, d, var.equal = TRUE)
    put(set, "jzs", 1 / exp(ttest.tstat(test$statistic, n[1], n[2], rscale = sqrt(2) / 2)$bf))
  }
  if (kind == "repeated" && k == 2) {
    test <- t.test(d$value[d$level == "l1"], d$value[d$level == "l2"], paired = TRUE)
    put(set, "jzs", 1 / exp(ttest.tstat(test$statistic, n[1], rscale = sqrt(2) / 2)$bf))
  }
}

write_to <- function(name, text) {
  file <- gzfile(file.path(folder, name), "w", compression = 9); writeLines(text, file); close(file)
}
write_to("anova-data.csv.gz", data_lines)
write_to("anova-golden.csv.gz", lines)
cat(length(lines) - 1, "figures of 200 data sets\n")
