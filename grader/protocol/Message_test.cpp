#include "protocol/Message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "protocol/Value.h"

namespace {

using namespace protocol;

/// Two ends of one socket, as between judge and runner.
class Channel : public testing::Test {
protected:
    Channel() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_), 0); }
    ~Channel() override {
        closeFarEnd();
        close(ends_[0]);
    }
    void closeFarEnd() {
        if (ends_[1] >= 0)
            close(ends_[1]);
        ends_[1] = -1;
    }
    ReadStatus readHere(std::size_t largest = 1000, int deadlineMs = 1000) {
        return readMessage(ends_[0], kAnswerMagic, largest, deadlineMs, body_);
    }
    int here() const { return ends_[0]; }
    int there() const { return ends_[1]; }

    Bytes body_;

private:
    int ends_[2] = {-1, -1};
};

Request someRequest() {
    Request request;
    request.nonce = {0x0123456789abcdef, 42};
    request.kind = RequestKind::frame;
    request.name = "from-the-right";
    request.arguments = encode(1.5f);
    request.alone = true;
    request.width = 400;
    request.height = 300;
    request.seed = 0xffffffffffffffff;
    request.timeoutMs = 4000;
    request.outputBytes = 65536;
    return request;
}

TEST(Message, ARequestComesBackAsItWas) {
    const Request sent = someRequest();
    const Request got = decodeRequest(encodeRequest(sent));
    EXPECT_EQ(got.nonce, sent.nonce);
    EXPECT_EQ(got.kind, sent.kind);
    EXPECT_EQ(got.name, sent.name);
    EXPECT_EQ(got.arguments, sent.arguments);
    EXPECT_EQ(got.census, sent.census);
    EXPECT_EQ(got.alone, sent.alone);
    EXPECT_EQ(got.width, sent.width);
    EXPECT_EQ(got.height, sent.height);
    EXPECT_EQ(got.seed, sent.seed);
    EXPECT_EQ(got.timeoutMs, sent.timeoutMs);
    EXPECT_EQ(got.outputBytes, sent.outputBytes);
}

TEST(Message, AnAnswerComesBackAsItWas) {
    Answer sent;
    sent.nonce = {7, 8};
    sent.outcome = Outcome::crash;
    sent.code = -11;
    sent.detail = std::string("turn\0Camera", 11);
    sent.todos = {"rotation", "", "look-at"};
    sent.payload = {1, 2, 3};
    const Answer got = decodeAnswer(encodeAnswer(sent));
    EXPECT_EQ(got.nonce, sent.nonce);
    EXPECT_EQ(got.outcome, sent.outcome);
    EXPECT_EQ(got.code, sent.code);
    EXPECT_EQ(got.detail, sent.detail);
    EXPECT_EQ(got.todos, sent.todos);
    EXPECT_EQ(got.payload, sent.payload);
}

TEST(Message, WhatDrawsComesBackAsItWas) {
    const GraphicsInfo got = decodeGraphics(encodeGraphics({"osmesa", "3.3", "llvmpipe"}));
    EXPECT_EQ(got.provider, "osmesa");
    EXPECT_EQ(got.version, "3.3");
    EXPECT_EQ(got.renderer, "llvmpipe");
}

TEST(Message, NoTwoNoncesAreTheSame) {
    EXPECT_NE(freshNonce(), freshNonce());
    EXPECT_NE(freshNonce(), Nonce{});
}

TEST(Message, EveryTruncationIsNoticed) {
    Answer answer;
    answer.detail = "text";
    answer.todos = {"a", "b"};
    answer.payload = {1, 2};
    const Bytes whole = encodeAnswer(answer);
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THROW(decodeAnswer(std::span(whole).first(size)), ProtocolError) << size;
    const Bytes request = encodeRequest(someRequest());
    for (std::size_t size = 0; size < request.size(); ++size)
        EXPECT_THROW(decodeRequest(std::span(request).first(size)), ProtocolError) << size;
}

TEST(Message, BytesThatFollowAreNoticed) {
    Bytes bytes = encodeAnswer({});
    bytes.push_back(0);
    EXPECT_THROW(decodeAnswer(bytes), ProtocolError);
}

TEST(Message, AnUnknownOutcomeOrKindIsNoticed) {
    Bytes answer = encodeAnswer({});
    answer[sizeof(Nonce)] = static_cast<std::uint8_t>(Outcome::faulty) + 1;
    EXPECT_THROW(decodeAnswer(answer), ProtocolError);
    Bytes request = encodeRequest({});
    request[sizeof(Nonce)] = static_cast<std::uint8_t>(RequestKind::graphics) + 1;
    EXPECT_THROW(decodeRequest(request), ProtocolError);
}

TEST(Message, ALieAboutTheNumberOfRegionsIsNoticed) {
    Answer answer;
    answer.todos = std::vector<std::string>(257, "x");
    EXPECT_THROW(decodeAnswer(encodeAnswer(answer)), ProtocolError);
}

TEST(Message, TextsAreCutAndLongerOnesAreRefused) {
    Answer answer;
    answer.detail = std::string(1 << 20, 'x');
    const Answer cut = decodeAnswer(encodeAnswer(answer));
    EXPECT_LT(cut.detail.size(), 20000u);
    Bytes forged = encodeAnswer(cut);
    const std::size_t length = sizeof(Nonce) + 1 + 4;  // where the text begins
    forged[length] = 0xff, forged[length + 1] = 0xff;
    forged.resize(forged.size() + 0xffff);
    EXPECT_THROW(decodeAnswer(forged), ProtocolError);
    answer.todos = {std::string(1 << 20, 'x')};
    EXPECT_THROW(decodeAnswer(encodeAnswer(answer)), ProtocolError);
}

TEST_F(Channel, AMessageArrivesWithItsNonce) {
    Answer sent;
    sent.nonce = {3, 4};
    ASSERT_TRUE(writeAll(there(), framed(kAnswerMagic, encodeAnswer(sent))));
    ASSERT_EQ(readHere(), ReadStatus::ok);
    EXPECT_EQ(decodeAnswer(body_).nonce, sent.nonce);
}

TEST_F(Channel, MessagesDoNotRunIntoEachOther) {
    ASSERT_TRUE(writeAll(there(), framed(kAnswerMagic, {1, 2, 3})));
    ASSERT_TRUE(writeAll(there(), framed(kAnswerMagic, {})));
    ASSERT_EQ(readHere(), ReadStatus::ok);
    EXPECT_EQ(body_, (Bytes{1, 2, 3}));
    ASSERT_EQ(readHere(), ReadStatus::ok);
    EXPECT_TRUE(body_.empty());
}

TEST_F(Channel, ALongMessageArrivesInPieces) {
    const Bytes large(4 << 20, 7);
    std::thread writer([&] { writeAll(there(), framed(kAnswerMagic, large)); });
    EXPECT_EQ(readHere(large.size(), 10000), ReadStatus::ok);
    writer.join();
    EXPECT_EQ(body_, large);
}

TEST_F(Channel, AnotherMagicNumberIsMalformed) {
    ASSERT_TRUE(writeAll(there(), framed(kRequestMagic, {1})));
    EXPECT_EQ(readHere(), ReadStatus::malformed);
}

TEST_F(Channel, ALengthBeyondTheLimitIsMalformedBeforeItComes) {
    ASSERT_TRUE(writeAll(there(), {'C', 'G', 'A', 'N', 0xff, 0xff, 0xff, 0xff}));
    EXPECT_EQ(readHere(), ReadStatus::malformed);
    ASSERT_TRUE(writeAll(there(), framed(kAnswerMagic, Bytes(11))));
    EXPECT_EQ(readHere(10), ReadStatus::malformed);
}

TEST_F(Channel, NothingInTimeIsLate) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(readHere(1000, 30), ReadStatus::late);
    EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(29));
}

TEST_F(Channel, HalfAMessageIsLateToo) {
    const Bytes whole = framed(kAnswerMagic, {1, 2, 3, 4});
    ASSERT_TRUE(writeAll(there(), Bytes(whole.begin(), whole.end() - 1)));
    EXPECT_EQ(readHere(1000, 30), ReadStatus::late);
}

TEST_F(Channel, ADripOfBytesDoesNotExtendTheDeadline) {
    std::thread dripping([&] {
        const Bytes whole = framed(kAnswerMagic, Bytes(100));
        for (int i = 0; i < 30; ++i) {
            writeAll(there(), {whole[static_cast<std::size_t>(i)]});
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    });
    EXPECT_EQ(readHere(1000, 80), ReadStatus::late);
    dripping.join();
}

TEST_F(Channel, AnEndThatCloses) {
    closeFarEnd();
    EXPECT_EQ(readHere(), ReadStatus::closed);
}

TEST_F(Channel, AnEndThatClosesInTheMiddle) {
    const Bytes whole = framed(kAnswerMagic, {1, 2, 3, 4});
    ASSERT_TRUE(writeAll(there(), Bytes(whole.begin(), whole.end() - 1)));
    closeFarEnd();
    EXPECT_EQ(readHere(), ReadStatus::closed);
}

TEST_F(Channel, WritingToAClosedEndSaysSo) {
    closeFarEnd();
    EXPECT_FALSE(writeAll(here(), Bytes(10)));  // and no SIGPIPE
}

}  // namespace
